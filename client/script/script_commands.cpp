#include "client/script/script_runner.h"
#include "client/script/script_view.h"
#include "client/tools/own_presets.h"
#include "common/base/text_lines.h"
#include "common/edit/protect_words.h"

namespace burnish {
namespace {

/// Applies NAME [STRENGTH]. The name may have several words; a number behind it is the strength.
Status apply_preset(ScriptLine line, Document& document) {
  const auto strength = parse_real(line.words.back());
  if (strength.is_ok() && line.words.size() > 1) {
    RETURN_IF_ERROR(check_strength(*strength));
    line.words.pop_back();
  }
  ASSIGN_OR_RETURN(const Preset preset, find_any_preset(line.rest()));
  document.apply(preset, strength.is_ok() ? *strength : 1);
  return Status::ok();
}

/// Parses PIN CAP KEEP.
Result<Controls> parse_controls(const std::vector<std::string>& words) {
  Controls controls;
  ASSIGN_OR_RETURN(controls.pin_rims, parse_switch(words[0]));
  ASSIGN_OR_RETURN(controls.cap, parse_real(words[1]));
  ASSIGN_OR_RETURN(controls.keep_volume, parse_switch(words[2]));
  RETURN_IF_ERROR(check_controls(controls));
  return controls;
}

Result<Equaliser> parse_bands(const std::vector<std::string>& words) {
  Equaliser equaliser;
  for (const std::string& word : words) {
    ASSIGN_OR_RETURN(const Band band, parse_band(word));
    equaliser.bands.push_back(band);
  }
  RETURN_IF_ERROR(check_equaliser(equaliser));
  return equaliser;
}

/// Parses BETA [ALPHA]. Fails: failed_precondition without colours.
Result<ColourFilter> parse_colours(const std::vector<std::string>& words,
                                   const Document& document) {
  ColourFilter filter = document.colour_filter();
  ASSIGN_OR_RETURN(filter.beta, parse_real(words[0]));
  if (words.size() > 1) {
    ASSIGN_OR_RETURN(filter.alpha, parse_real(words[1]));
  }
  RETURN_IF_ERROR(check_colour_filter(filter));
  if (!document.has_colours()) return failed_precondition("the scan has no colours to edit");
  return filter;
}

/// Parses RADIUS STRENGTH BETA [FALLOFF [WHAT]].
Result<Brush> parse_brush(const std::vector<std::string>& words) {
  Brush brush;
  ASSIGN_OR_RETURN(brush.radius, parse_real(words[0]));
  ASSIGN_OR_RETURN(brush.strength, parse_real(words[1]));
  ASSIGN_OR_RETURN(brush.beta, parse_real(words[2]));
  if (words.size() > 3) {
    ASSIGN_OR_RETURN(brush.fall_off, parse_fall_off(words[3]));
  }
  if (words.size() > 4) RETURN_IF_ERROR(parse_painted(words[4], brush));
  RETURN_IF_ERROR(validate(Stroke{brush, {Vec3d::Zero()}}));
  return brush;
}

Result<Stroke> parse_stroke(const std::vector<std::string>& words) {
  Stroke stroke;
  const size_t first = parse_real(words[4]).is_ok() ? 4 : 5;  // a word before the points: WHAT
  ASSIGN_OR_RETURN(stroke.brush, parse_brush({words.begin(), words.begin() + first}));
  ASSIGN_OR_RETURN(const std::vector<double> numbers, parse_numbers(words, first));
  if (numbers.size() % 3 != 0) return invalid_argument("a point must be three numbers");
  for (size_t i = 0; i < numbers.size(); i += 3)
    stroke.path.emplace_back(numbers[i], numbers[i + 1], numbers[i + 2]);
  RETURN_IF_ERROR(validate(stroke));
  return stroke;
}

Result<ColourBy> parse_colour(const std::string& word) {
  static constexpr std::string_view kNames[] = {"clay", "beta", "curvature", "displacement",
                                                "scan"};  // as ColourBy
  for (size_t i = 0; i < std::size(kNames); ++i)
    if (word == kNames[i]) return static_cast<ColourBy>(i);
  return invalid_argument("'" + word + "' is not clay, beta, curvature, displacement or scan");
}

Status set_camera(const std::vector<double>& numbers, Viewport& viewport) {
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

Status ScriptRunner::run_edit(const ScriptLine& line) {
  Document& document = *workspace_->document();
  const std::string& command = line.command;
  if (command == "beta") {
    ASSIGN_OR_RETURN(const double beta, parse_real(line.words[0]));
    RETURN_IF_ERROR(check_beta(beta));
    document.preview_beta(beta);
    document.commit_beta();
  } else if (command == "fidelity") {
    ASSIGN_OR_RETURN(const double alpha, parse_real(line.words[0]));
    RETURN_IF_ERROR(check_alpha(alpha));
    document.curve().set_fidelity(alpha);
    document.commit_curve();
  } else if (command == "curve") {
    ASSIGN_OR_RETURN(const TransferCurve curve, TransferCurve::parse(line.words[0]));
    document.curve().set_curve(curve);
    document.commit_curve();
  } else if (command == "preset") {
    RETURN_IF_ERROR(apply_preset(line, document));
  } else if (command == "controls") {
    ASSIGN_OR_RETURN(const Controls controls, parse_controls(line.words));
    document.set_controls(controls);
  } else if (command == "protect") {
    ASSIGN_OR_RETURN(Protect change, parse_protect(line.words));
    document.protect(std::move(change));
  } else if (command == "bands") {
    ASSIGN_OR_RETURN(Equaliser equaliser, parse_bands(line.words));
    document.set_equaliser(std::move(equaliser));
  } else if (command == "palette") {
    ASSIGN_OR_RETURN(Palette palette, parse_palette_line(line.rest()));
    document.set_palette(std::move(palette));
  } else if (command == "colours") {
    ASSIGN_OR_RETURN(const ColourFilter filter, parse_colours(line.words, document));
    document.set_colour_filter(filter);
  } else if (command == "brush") {
    ASSIGN_OR_RETURN(document.brush().brush, parse_brush(line.words));
  } else if (command == "stroke") {
    ASSIGN_OR_RETURN(const Stroke stroke, parse_stroke(line.words));
    document.paint(stroke);
  } else if (command == "mirror") {
    RETURN_IF_ERROR(change_mirror(line, document));
  } else if (command == "undo") {
    document.undo();
  } else if (command == "redo") {
    document.redo();
  } else if (command == "switch") {
    ASSIGN_OR_RETURN(const int number, parse_integer(line.words[0]));
    ASSIGN_OR_RETURN(const bool on, parse_switch(line.words[1]));
    document.switch_entry(static_cast<uint64_t>(number), on);
  } else if (command == "checkpoint") {
    document.set_checkpoint(line.rest());
  } else if (command == "restore") {
    document.restore_checkpoint(line.rest());
  } else {
    const std::string name = line.rest();
    RETURN_IF_ERROR(save_edits());
    workspace_->fork(name, "");
    return update_until([&] { return workspace_->document()->session().name == name; }, "forking");
  }
  return Status::ok();
}

Status ScriptRunner::run_view(const ScriptLine& line) {
  Document& document = *workspace_->document();
  Viewport& viewport = workspace_->viewport;
  const std::string& command = line.command;
  if (command == "camera") {
    ASSIGN_OR_RETURN(const std::vector<double> numbers, parse_numbers(line.words, 0));
    is_camera_placed_ = numbers.size() > 2;
    return set_camera(numbers, viewport);
  }
  if (is_light_command(command)) return change_lighting(line, viewport.options.lighting);
  if (command == "up") {
    ASSIGN_OR_RETURN(const UpAxis up, parse_up_axis(line.words[0]));
    is_camera_placed_ = false;
    viewport.set_up(up);
    return Status::ok();
  }
  if (command == "view") {
    ASSIGN_OR_RETURN(const StandardView view, parse_standard_view(line.words[0]));
    is_camera_placed_ = false;
    viewport.show_from(view);
    return Status::ok();
  }
  if (command == "frame") {
    is_camera_placed_ = false;
    return frame(line.words, viewport);
  }
  if (command == "colour") {
    ASSIGN_OR_RETURN(const ColourBy colour, parse_colour(line.words[0]));
    if (colour == ColourBy::kScan && !document.has_colours())
      return failed_precondition("scan " + document.scan().scan.name + " has no colours");
    document.set_colour(colour);
    return finish_picture();
  }
  if (command == "size") {
    ImageSize size;
    if (std::sscanf(line.words[0].c_str(), "%5dx%5d", &size.width, &size.height) != 2)
      return invalid_argument("'" + line.words[0] + "' is not WIDTHxHEIGHT");
    RETURN_IF_ERROR(check_image_size(size));
    viewport.set_size(size);
    if (!is_camera_placed_) viewport.frame_all();
    return Status::ok();
  }
  ASSIGN_OR_RETURN(const bool on, parse_switch(line.words[0]));
  if (command == "flat") viewport.options.flat = on;
  if (command == "wireframe") viewport.options.wireframe = on;
  if (command == "split") viewport.options.split = on;
  if (command == "original") viewport.hold_original = on;
  if (command == "orthographic") viewport.camera.orthographic = on;
  return Status::ok();
}

Status ScriptRunner::run_pointer(const ScriptLine& line) {
  ASSIGN_OR_RETURN(const std::vector<double> numbers, parse_numbers(line.words, 0));
  if (numbers.size() % 2 != 0) return invalid_argument("a pixel must be two numbers");
  RETURN_IF_ERROR(finish_picture());  // the same points on every run
  Viewport& viewport = workspace_->viewport;
  const auto button = line.command == "drag" ? PointerButton::kLeft : PointerButton::kMiddle;
  viewport.press(button, {}, {numbers[0], numbers[1]});
  for (size_t i = 0; i < numbers.size(); i += 2) {
    viewport.move({numbers[i], numbers[i + 1]});
    RETURN_IF_ERROR(update());
  }
  viewport.release(button);
  RETURN_IF_ERROR(update());
  viewport.leave();
  return Status::ok();
}

}  // namespace burnish
