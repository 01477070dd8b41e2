#include "client/script/script_edits.h"

#include <algorithm>
#include <string_view>

#include "client/script/script_view.h"
#include "client/tools/own_presets.h"
#include "common/base/text_lines.h"
#include "common/edit/proposed_edges.h"
#include "common/edit/protect_words.h"

namespace burnish {

Result<ChosenPreset> parse_preset(std::vector<std::string> words) {
  const auto strength = parse_real(words.back());
  const bool has_strength = strength.is_ok() && words.size() > 1;
  if (has_strength) {
    RETURN_IF_ERROR(check_strength(*strength));
    words.pop_back();
  }
  std::string name;
  for (const std::string& word : words) name += (name.empty() ? "" : " ") + word;
  ASSIGN_OR_RETURN(Preset preset, find_any_preset(name));
  return ChosenPreset{std::move(preset), has_strength ? *strength : 1};
}

Result<ExportLine> parse_export(const std::vector<std::string>& words) {
  ExportLine line{words[0]};
  for (size_t i = 1; i < words.size(); ++i) {
    if (words[i] != "exact" && words[i] != "record")
      return invalid_argument("'" + words[i] + "' is neither 'exact' nor 'record'");
    (words[i] == "exact" ? line.is_exact : line.has_record) = true;
  }
  return line;
}

Result<Controls> parse_controls(const std::vector<std::string>& words) {
  Controls controls;
  ASSIGN_OR_RETURN(controls.pin_rims, parse_switch(words[0]));
  ASSIGN_OR_RETURN(controls.cap, parse_real(words[1]));
  ASSIGN_OR_RETURN(controls.keep_volume, parse_switch(words[2]));
  RETURN_IF_ERROR(check_controls(controls));
  return controls;
}

static Result<Equaliser> parse_bands(const std::vector<std::string>& words) {
  Equaliser equaliser;
  for (const std::string& word : words) {
    ASSIGN_OR_RETURN(const Band band, parse_band(word));
    equaliser.bands.push_back(band);
  }
  RETURN_IF_ERROR(check_equaliser(equaliser));
  return equaliser;
}

static Result<EdgeFilter> parse_edges(const std::vector<std::string>& words) {
  EdgeFilter edges;
  if (words == std::vector<std::string>{"off"}) return edges;
  if (words.size() != 5)
    return invalid_argument("edges are off, or FILTER STRENGTH ANGLE PASSES CRISPNESS");
  ASSIGN_OR_RETURN(edges.kind, parse_normal_filter(words[0]));
  ASSIGN_OR_RETURN(edges.strength, parse_real(words[1]));
  ASSIGN_OR_RETURN(edges.edge_angle, parse_real(words[2]));
  ASSIGN_OR_RETURN(edges.passes, parse_integer(words[3]));
  ASSIGN_OR_RETURN(edges.crispness, parse_real(words[4]));
  RETURN_IF_ERROR(check_edge_filter(edges));
  return edges;
}

static Result<ColourFilter> parse_colours(const std::vector<std::string>& words,
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

Result<std::optional<Change>> parse_setting(const ScriptLine& line, const Document& document) {
  if (line.command == "beta") {
    ASSIGN_OR_RETURN(const double beta, parse_real(line.words[0]));
    RETURN_IF_ERROR(check_beta(beta));
    return std::optional<Change>(SetGradientScale{beta});
  }
  if (line.command == "bands") {
    ASSIGN_OR_RETURN(Equaliser equaliser, parse_bands(line.words));
    return std::optional<Change>(SetEqualiser{std::move(equaliser)});
  }
  if (line.command == "edges") {
    ASSIGN_OR_RETURN(const EdgeFilter edges, parse_edges(line.words));
    return std::optional<Change>(SetEdges{edges});
  }
  if (line.command == "palette") {
    ASSIGN_OR_RETURN(Palette palette, parse_palette_line(line.rest()));
    return std::optional<Change>(SetPalette{std::move(palette)});
  }
  if (line.command == "colours") {
    ASSIGN_OR_RETURN(const ColourFilter filter, parse_colours(line.words, document));
    return std::optional<Change>(SetColour{filter});
  }
  return std::optional<Change>();
}

namespace {

/// Parses RADIUS STRENGTH BETA [FALLOFF [WHAT] [through]].
Result<Brush> parse_brush(const std::vector<std::string>& words) {
  Brush brush;
  ASSIGN_OR_RETURN(brush.radius, parse_real(words[0]));
  ASSIGN_OR_RETURN(brush.strength, parse_real(words[1]));
  ASSIGN_OR_RETURN(brush.beta, parse_real(words[2]));
  if (words.size() > 3) {
    ASSIGN_OR_RETURN(brush.fall_off, parse_fall_off(words[3]));
  }
  const auto behind = words.begin() + std::min(words.size(), size_t{4});
  RETURN_IF_ERROR(parse_brush_words(std::vector<std::string_view>(behind, words.end()), brush));
  RETURN_IF_ERROR(validate(Stroke{brush, {Vec3d::Zero()}}));
  return brush;
}

Result<Stroke> parse_stroke(const std::vector<std::string>& words) {
  Stroke stroke;
  size_t first = 4;  // words before the points: WHAT, through
  while (first < words.size() && !parse_real(words[first]).is_ok()) ++first;
  ASSIGN_OR_RETURN(stroke.brush, parse_brush({words.begin(), words.begin() + first}));
  ASSIGN_OR_RETURN(const std::vector<double> numbers, parse_numbers(words, first));
  if (numbers.size() % 3 != 0) return invalid_argument("a point must be three numbers");
  for (size_t i = 0; i < numbers.size(); i += 3)
    stroke.path.emplace_back(numbers[i], numbers[i + 1], numbers[i + 2]);
  RETURN_IF_ERROR(validate(stroke));
  return stroke;
}

}  // namespace

Status change_document(const ScriptLine& line, Document& document) {
  const std::string& command = line.command;
  ASSIGN_OR_RETURN(auto setting, parse_setting(line, document));
  if (setting) {
    document.commit(std::move(*setting));
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
    ASSIGN_OR_RETURN(const ChosenPreset chosen, parse_preset(line.words));
    document.apply(chosen.preset, chosen.strength);
  } else if (command == "keep_edges" && line.words[0] == kAutoEdges) {
    document.keep_edges_by_noise();
  } else if (command == "keep_edges") {
    ASSIGN_OR_RETURN(const EdgePreset preset, find_edge_preset(line.words[0]));
    document.keep_edges(preset.filter);
  } else if (command == "controls") {
    ASSIGN_OR_RETURN(const Controls controls, parse_controls(line.words));
    document.set_controls(controls);
  } else if (command == "protect") {
    ASSIGN_OR_RETURN(Protect change, parse_protect(line.words));
    document.protect(std::move(change));
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
    return invalid_argument("'" + command + "' changes no session");
  }
  return Status::ok();
}

}  // namespace burnish
