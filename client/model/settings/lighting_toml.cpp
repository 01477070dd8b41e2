#include "client/model/settings/lighting_toml.h"

namespace burnish {

toml::table to_toml(const Lighting& lighting) {
  return toml::table{{"kind", name_of(lighting.kind)},
                     {"azimuth", lighting.azimuth_degrees},
                     {"elevation", lighting.elevation_degrees},
                     {"specular", lighting.specular},
                     {"occlusion", lighting.occlusion},
                     {"radiance", lighting.radiance},
                     {"ridge", lighting.ridge},
                     {"valley", lighting.valley}};
}

Lighting lighting_of(const toml::table& table) {
  Lighting lighting;
  const auto read = [&](const char* key, double& value) { value = table[key].value_or(value); };
  const auto kind = parse_light_kind(table["kind"].value_or(name_of(lighting.kind)));
  if (kind.is_ok()) lighting.kind = *kind;
  read("azimuth", lighting.azimuth_degrees);
  read("elevation", lighting.elevation_degrees);
  read("specular", lighting.specular);
  read("occlusion", lighting.occlusion);
  read("radiance", lighting.radiance);
  read("ridge", lighting.ridge);
  read("valley", lighting.valley);
  return check_lighting(lighting).is_ok() ? lighting : Lighting{};
}

}  // namespace burnish
