#include "client/script/script_view.h"

#include <algorithm>
#include <array>

#include "common/base/text_lines.h"

namespace burnish {

static constexpr std::array<std::string_view, 6> kLightCommands = {
    "light", "light_direction", "specular", "occlusion", "radiance", "cavity"};

bool is_light_command(std::string_view command) {
  return std::ranges::find(kLightCommands, command) != kLightCommands.end();
}

Status change_lighting(const ScriptLine& line, Lighting& lighting) {
  Lighting changed = lighting;
  if (line.command == "light") {
    ASSIGN_OR_RETURN(lighting.kind, parse_light_kind(line.words[0]));
    return Status::ok();
  }
  ASSIGN_OR_RETURN(const std::vector<double> numbers, parse_numbers(line.words, 0));
  if (line.command == "light_direction") {
    changed.azimuth_degrees = numbers[0];
    changed.elevation_degrees = numbers[1];
  }
  if (line.command == "specular") changed.specular = numbers[0];
  if (line.command == "occlusion") changed.occlusion = numbers[0];
  if (line.command == "radiance") changed.radiance = numbers[0];
  if (line.command == "cavity") {
    changed.ridge = numbers[0];
    changed.valley = numbers[1];
  }
  RETURN_IF_ERROR(check_lighting(changed));
  lighting = changed;
  return Status::ok();
}

Status change_mirror(const ScriptLine& line, Document& document) {
  if (line.words[0] == "off") {
    document.mirror.reset();
    return Status::ok();
  }
  ASSIGN_OR_RETURN(const int axis, parse_axis(line.words[0]));
  ASSIGN_OR_RETURN(const std::vector<double> places, parse_numbers(line.words, 1));
  document.mirror = MirrorPlane{axis, places.empty() ? document.box().center()[axis] : places[0]};
  return Status::ok();
}

}  // namespace burnish
