// Preferences and views of sessions: a window keeps them in files, the page in its store.

#include <algorithm>

#include <nlohmann/json.hpp>

#include "client/model/settings/preferences.h"
#include "client/model/view/view_state.h"
#include "client/web/core/host/store.h"
#include "client/web/core/json_writer.h"

namespace burnish {

namespace {

using Json = nlohmann::json;

/// Reads members of an object that may be damaged: what does not fit stays as it is.
class Reader {
 public:
  explicit Reader(const Json& object) : object_(object) {}

  void take(const char* name, double& value) const {
    if (const Json* const found = find(name); found && found->is_number()) value = *found;
  }
  void take(const char* name, bool& value) const {
    if (const Json* const found = find(name); found && found->is_boolean()) value = *found;
  }
  void take(const char* name, std::string& value) const {
    if (const Json* const found = find(name); found && found->is_string()) value = *found;
  }
  template <typename Kind>
  void take_kind(const char* name, int kinds, Kind& value) const {
    double number = static_cast<double>(value);
    take(name, number);
    if (number >= 0 && number < kinds) value = static_cast<Kind>(static_cast<int>(number));
  }
  const Json* find(const char* name) const {
    const auto found = object_.is_object() ? object_.find(name) : object_.end();
    return found == object_.end() ? nullptr : &*found;
  }

 private:
  const Json& object_;
};

Json stored_json(const std::string& key) {
  return Json::parse(stored_text(key), nullptr, false);
}

void write(const Lighting& light, JsonWriter& json) {
  json.open().whole("kind", static_cast<int>(light.kind)).number("azimuth", light.azimuth_degrees);
  json.number("elevation", light.elevation_degrees).number("specular", light.specular);
  json.number("occlusion", light.occlusion).number("radiance", light.radiance);
  json.number("ridge", light.ridge).number("valley", light.valley).close();
}

Lighting lighting_in(const Json& object) {
  Lighting light;
  const Reader reader(object);
  reader.take_kind("kind", kLightKinds, light.kind);
  reader.take("azimuth", light.azimuth_degrees);
  reader.take("elevation", light.elevation_degrees);
  reader.take("specular", light.specular);
  reader.take("occlusion", light.occlusion);
  reader.take("radiance", light.radiance);
  reader.take("ridge", light.ridge);
  reader.take("valley", light.valley);
  return check_lighting(light).is_ok() ? light : Lighting();
}

void write(const Camera& camera, JsonWriter& json) {
  json.open().number("azimuth", camera.azimuth_degrees);
  json.number("elevation", camera.elevation_degrees).number("distance", camera.distance);
  json.number("zoom", camera.zoom).whole("up", static_cast<int>(camera.up));
  json.flag("orthographic", camera.orthographic);
  json.number("x", camera.target.x()).number("y", camera.target.y()).number("z", camera.target.z());
  json.close();
}

Camera camera_in(const Json& object) {
  Camera camera;
  const Reader reader(object);
  reader.take("azimuth", camera.azimuth_degrees);
  reader.take("elevation", camera.elevation_degrees);
  reader.take("distance", camera.distance);
  reader.take("zoom", camera.zoom);
  reader.take_kind("up", kUpAxes, camera.up);
  reader.take("orthographic", camera.orthographic);
  reader.take("x", camera.target.x());
  reader.take("y", camera.target.y());
  reader.take("z", camera.target.z());
  return camera;
}

void write(const char* name, const ColourEnds& ends, JsonWriter& json) {
  json.key(name).open_list().number(ends.low).number(ends.high).close_list();
}

ColourEnds ends_in(const Reader& reader, const char* name, double otherwise) {
  const Json* const found = reader.find(name);
  const auto end = [&](size_t number) {
    const bool is_there = found && found->is_array() && number < found->size();
    return clamped_end(is_there && (*found)[number].is_number() ? (*found)[number].get<double>()
                                                                : otherwise);
  };
  return {end(0), end(1)};
}

std::string key_of(const ViewKey& key) {
  return key.server + " " + key.session;
}

void write(const ViewState& view, JsonWriter& json) {
  json.text("scan", view.scan).key("camera");
  write(view.camera, json);
  json.key("light");
  write(view.options.lighting, json);
  json.flag("flat", view.options.flat).flag("wireframe", view.options.wireframe);
  json.flag("split", view.options.split).number("splitAt", view.options.split_at);
  write("displacement", view.options.displacement, json);
  write("curvature", view.options.curvature, json);
  json.flag("scaleBar", view.options.scale_bar).flag("axes", view.options.axes);
  json.whole("colour", static_cast<int>(view.colour)).key("bookmarks").open_list();
  for (size_t i = 0; i < std::min(view.bookmarks.size(), kBookmarksMax); ++i)
    write(view.bookmarks[i], json);
  json.close_list();
}

ViewState view_in(const Json& object) {
  constexpr int kColours = 5;  // of ColourBy
  ViewState view;
  const Reader reader(object);
  reader.take("scan", view.scan);
  if (const Json* const camera = reader.find("camera")) view.camera = camera_in(*camera);
  if (const Json* const light = reader.find("light")) view.options.lighting = lighting_in(*light);
  reader.take("flat", view.options.flat);
  reader.take("wireframe", view.options.wireframe);
  reader.take("split", view.options.split);
  reader.take("splitAt", view.options.split_at);
  double range = 1;  // of earlier versions
  reader.take("displacementRange", range);
  view.options.displacement = ends_in(reader, "displacement", range);
  view.options.curvature = ends_in(reader, "curvature", 1);
  reader.take("scaleBar", view.options.scale_bar);
  reader.take("axes", view.options.axes);
  reader.take_kind("colour", kColours, view.colour);
  const Json* const bookmarks = reader.find("bookmarks");
  if (bookmarks && bookmarks->is_array())
    for (const Json& each : *bookmarks)
      if (view.bookmarks.size() < kBookmarksMax) view.bookmarks.push_back(camera_in(each));
  return view;
}

void write(const RecentSession& recent, JsonWriter& json) {
  json.open().text("server", recent.server).text("session", recent.session);
  json.text("scan", recent.scan).text("id", recent.id).text("scanName", recent.scan_name);
  json.whole("shown", recent.shown_unix_seconds);
  json.whole("bytes", static_cast<int64_t>(recent.size_bytes)).close();
}

RecentSession recent_in(const Json& object) {
  RecentSession recent;
  const Reader reader(object);
  double shown = 0, bytes = 0;
  reader.take("server", recent.server);
  reader.take("session", recent.session);
  reader.take("scan", recent.scan);
  reader.take("id", recent.id);
  reader.take("scanName", recent.scan_name);
  reader.take("shown", shown);
  reader.take("bytes", bytes);
  recent.shown_unix_seconds = static_cast<int64_t>(shown);
  recent.size_bytes = static_cast<uint64_t>(std::max(0.0, bytes));
  return recent;
}

}  // namespace

// The page knows its server and its user itself.
Result<Preferences> read_preferences(const std::filesystem::path& path) {
  const Json stored = stored_json(path.string());
  Preferences preferences;
  const Reader reader(stored);
  reader.take("brushRadiusPart", preferences.brush_radius_part);
  reader.take("brushStrength", preferences.brush_strength);
  reader.take("brushBeta", preferences.brush_beta);
  reader.take("penPressure", preferences.pen_pressure);
  if (const Json* const light = reader.find("light")) preferences.lighting = lighting_in(*light);
  const Json* const recent = reader.find("recent");
  if (recent && recent->is_array())
    for (const Json& each : *recent)
      if (preferences.recent.size() < kRecentMax) preferences.recent.push_back(recent_in(each));
  return preferences;
}

Status write_preferences(const Preferences& preferences, const std::filesystem::path& path) {
  JsonWriter json;
  json.open().number("brushRadiusPart", preferences.brush_radius_part);
  json.number("brushStrength", preferences.brush_strength);
  json.number("brushBeta", preferences.brush_beta);
  json.flag("penPressure", preferences.pen_pressure).key("light");
  write(preferences.lighting, json);
  json.key("recent").open_list();
  for (const RecentSession& recent : preferences.recent) write(recent, json);
  json.close_list().close();
  store_text(path.string(), json.written());
  return Status::ok();
}

std::optional<ViewState> read_view(const std::filesystem::path& file, const ViewKey& key) {
  const Json stored = stored_json(file.string());
  if (!stored.is_array()) return std::nullopt;
  for (const Json& each : stored) {
    std::string name;
    Reader(each).take("key", name);
    if (name == key_of(key)) return view_in(each);
  }
  return std::nullopt;
}

std::optional<UpAxis> read_up(const std::filesystem::path& file, const std::string& scan) {
  const Json stored = stored_json(file.string());
  if (!stored.is_array()) return std::nullopt;
  for (const Json& each : stored)
    if (const ViewState view = view_in(each); view.scan == scan) return view.camera.up;
  return std::nullopt;
}

Status write_view(const std::filesystem::path& file, const ViewKey& key, const ViewState& view) {
  const Json stored = stored_json(file.string());
  JsonWriter json;
  json.open_list().open().text("key", key_of(key));
  write(view, json);
  json.close();
  size_t views = 1;
  for (const Json& each : stored.is_array() ? stored : Json::array()) {
    std::string name;
    Reader(each).take("key", name);
    if (name == key_of(key) || ++views > kViewsMax) continue;
    json.open().text("key", name);
    write(view_in(each), json);
    json.close();
  }
  store_text(file.string(), json.close_list().written());
  return Status::ok();
}

}  // namespace burnish
