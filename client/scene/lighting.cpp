#include "client/scene/lighting.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "common/base/line_text.h"

namespace burnish {

static constexpr double kRadians = std::numbers::pi / 180;
static constexpr std::array<std::string_view, kLightKinds> kNames = {
    "clay",    "radiance", "cavity", "raking",
    "ceramic", "bronze",   "slopes", "unlit"};  // as LightKind

static Status check_within(const char* name, double value, double low, double high) {
  if (value >= low && value <= high) return Status::ok();
  LineText text;
  text << name << " " << value << " is outside " << low << " to " << high;
  return invalid_argument(text.text());
}

Status check_lighting(const Lighting& lighting) {
  RETURN_IF_ERROR(check_within("light azimuth", lighting.azimuth_degrees, -360, 360));
  RETURN_IF_ERROR(check_within("light elevation", lighting.elevation_degrees, 0, 90));
  RETURN_IF_ERROR(check_within("specular", lighting.specular, 0, 1));
  RETURN_IF_ERROR(check_within("occlusion", lighting.occlusion, 0, 1));
  RETURN_IF_ERROR(check_within("radiance", lighting.radiance, 0, kRadianceMax));
  RETURN_IF_ERROR(check_within("ridge", lighting.ridge, 0, kCavityMax));
  return check_within("valley", lighting.valley, 0, kCavityMax);
}

std::string_view name_of(LightKind kind) {
  return kNames[static_cast<size_t>(kind)];
}

std::string light_kind_names() {
  std::string names;
  for (const std::string_view name : kNames)
    names += (names.empty() ? "" : ", ") + std::string(name);
  return names;
}

Result<LightKind> parse_light_kind(std::string_view name) {
  const auto found = std::ranges::find(kNames, name);
  if (found != kNames.end()) return static_cast<LightKind>(found - kNames.begin());
  return invalid_argument("light '" + std::string(name) + "' is not one of " + light_kind_names());
}

Vec3f to_lamp(const Lighting& lighting) {
  const double azimuth = lighting.azimuth_degrees * kRadians;
  const double elevation = lighting.elevation_degrees * kRadians;
  return Vec3d(std::cos(azimuth) * std::cos(elevation), std::sin(azimuth) * std::cos(elevation),
               std::sin(elevation))
      .cast<float>();
}

Lighting with_lamp_at(Lighting lighting, const Eigen::Vector2d& on_ball) {
  if (on_ball.norm() > 0)
    lighting.azimuth_degrees = std::atan2(on_ball.y(), on_ball.x()) / kRadians;
  lighting.elevation_degrees = std::acos(std::min(on_ball.norm(), 1.0)) / kRadians;
  return lighting;
}

Eigen::Vector2d lamp_on_ball(const Lighting& lighting) {
  return to_lamp(lighting).head<2>().cast<double>();
}

bool needs_surroundings(const Lighting& lighting) {
  return lighting.kind == LightKind::kRadiance || lighting.kind == LightKind::kCavity ||
         lighting.occlusion > 0;
}

std::vector<std::string> script_lines(const Lighting& lighting) {
  const auto line = [](std::string_view command, std::initializer_list<double> values) {
    LineText text;
    text << command;
    for (const double value : values) text << ' ' << value;
    return text.text();
  };
  return {"light " + std::string(name_of(lighting.kind)),
          line("light_direction", {lighting.azimuth_degrees, lighting.elevation_degrees}),
          line("specular", {lighting.specular}),
          line("occlusion", {lighting.occlusion}),
          line("radiance", {lighting.radiance}),
          line("cavity", {lighting.ridge, lighting.valley})};
}

}  // namespace burnish
