#include <algorithm>
#include <iterator>

#include "client/script/script_view.h"
#include "common/base/text_lines.h"

namespace burnish {

bool is_view_command(std::string_view command) {
  static constexpr std::string_view kViewCommands[] = {
      "camera", "frame", "colour",   "flat",         "wireframe", "split",
      "up",     "view",  "original", "orthographic", "scale_bar"};
  return is_light_command(command) ||
         std::ranges::find(kViewCommands, command) != std::end(kViewCommands);
}

namespace {

Result<ColourBy> parse_colour(const std::string& word) {
  static constexpr std::string_view kNames[] = {"clay", "beta", "curvature", "displacement",
                                                "scan"};  // as ColourBy
  for (size_t i = 0; i < std::size(kNames); ++i)
    if (word == kNames[i]) return static_cast<ColourBy>(i);
  return invalid_argument("'" + word + "' is not clay, beta, curvature, displacement or scan");
}

Status set_camera(const std::vector<double>& numbers, Viewport& viewport) {
  if (numbers.size() != 2 && numbers.size() != 3 && numbers.size() != 6)
    return invalid_argument("camera has " + std::to_string(numbers.size()) +
                            " numbers; it takes 2, with a distance 3, with a target 6");
  viewport.camera.azimuth_degrees = numbers[0];
  viewport.camera.elevation_degrees = numbers[1];
  viewport.frame_all();
  if (numbers.size() > 2) viewport.camera.distance = numbers[2];
  if (numbers.size() == 6) viewport.camera.target = Vec3d(numbers[3], numbers[4], numbers[5]);
  return Status::ok();
}

Status frame(const std::vector<std::string>& words, Viewport& viewport) {
  static constexpr double kFartherMin = 1, kFartherMax = 10;
  ASSIGN_OR_RETURN(const std::vector<double> numbers, parse_numbers(words, 0));
  const double farther = numbers.empty() ? 1 : numbers[0];
  if (!(farther >= kFartherMin && farther <= kFartherMax))
    return invalid_argument("'" + words[0] + "' times the distance is outside 1..10");
  viewport.frame_all();
  viewport.camera.distance *= farther;
  return Status::ok();
}

}  // namespace

Status change_view(const ScriptLine& line, Workspace& workspace) {
  Document& document = *workspace.document();
  Viewport& viewport = workspace.viewport;
  const std::string& command = line.command;
  if (command == "camera") {
    ASSIGN_OR_RETURN(const std::vector<double> numbers, parse_numbers(line.words, 0));
    return set_camera(numbers, viewport);
  }
  if (is_light_command(command)) return change_lighting(line, viewport.options.lighting);
  if (command == "up") {
    ASSIGN_OR_RETURN(const UpAxis up, parse_up_axis(line.words[0]));
    viewport.set_up(up);
    return Status::ok();
  }
  if (command == "view") {
    ASSIGN_OR_RETURN(const StandardView view, parse_standard_view(line.words[0]));
    viewport.show_from(view);
    return Status::ok();
  }
  if (command == "frame") return frame(line.words, viewport);
  if (command == "colour") {
    ASSIGN_OR_RETURN(const ColourBy colour, parse_colour(line.words[0]));
    if (colour == ColourBy::kScan && !document.has_colours())
      return failed_precondition("scan " + document.scan().scan.name + " has no colours");
    document.set_colour(colour);
    return Status::ok();
  }
  ASSIGN_OR_RETURN(const bool on, parse_switch(line.words[0]));
  if (command == "flat") viewport.options.flat = on;
  if (command == "wireframe") viewport.options.wireframe = on;
  if (command == "split") viewport.options.split = on;
  if (command == "original") viewport.hold_original = on;
  if (command == "orthographic") viewport.camera.orthographic = on;
  if (command == "scale_bar") viewport.options.scale_bar = on;
  return Status::ok();
}

}  // namespace burnish
