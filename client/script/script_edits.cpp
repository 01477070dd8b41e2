#include "client/script/script_edits.h"

#include <utility>

#include "client/script/script_view.h"
#include "client/tools/own_presets.h"
#include "common/base/text_lines.h"
#include "common/edit/edit_lines.h"
#include "common/edit/proposed_edges.h"

namespace burnish {

Result<ChosenPreset> parse_preset(std::vector<std::string> words) {
  const auto strength = parse_real(words.back());
  const bool has_strength = strength.is_ok() && words.size() > 1;
  if (has_strength) {
    RETURN_IF_ERROR(check_strength(*strength));
    words.pop_back();
  }
  ASSIGN_OR_RETURN(Preset preset, find_any_preset(joined(words)));
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

Result<Change> parse_change(const ScriptLine& line, const Document& document) {
  ASSIGN_OR_RETURN(Change change, parse_edit(line.command, line.words, document.settings()));
  if (needs_colours(change) && !document.has_colours())
    return failed_precondition("the scan has no colours to edit");
  return change;
}

Status change_document(const ScriptLine& line, Document& document) {
  const std::string& command = line.command;
  if (command == "fidelity") {
    ASSIGN_OR_RETURN(const double alpha, parse_real(line.words[0]));
    RETURN_IF_ERROR(check_alpha(alpha));
    document.curve().set_fidelity(alpha);
    document.commit_curve();
  } else if (command == "preset") {
    ASSIGN_OR_RETURN(const ChosenPreset chosen, parse_preset(line.words));
    document.apply(chosen.preset, chosen.strength);
  } else if (command == "keep_edges" && line.words[0] == kAutoEdges) {
    document.keep_edges_by_noise();
  } else if (command == "keep_edges" && line.words[0] == kNoEdges) {
    document.keep_no_edges();
  } else if (command == "keep_edges") {
    const auto preset = find_edge_preset(line.words[0]);
    if (!preset.is_ok())
      return invalid_argument(preset.status().message() + ", " + kAutoEdges + ", " + kNoEdges);
    document.keep_edges(preset->filter);
  } else if (command == "brush") {
    ASSIGN_OR_RETURN(document.brush().brush, parse_brush(line.words));
  } else if (command == "mirror") {
    RETURN_IF_ERROR(change_mirror(line, document));
  } else {
    ASSIGN_OR_RETURN(Change change, parse_change(line, document));
    document.edit(std::move(change));
  }
  return Status::ok();
}

}  // namespace burnish
