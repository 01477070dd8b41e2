// Values that a drag passes: the line with the same words, without `preview`, ends it.

#include "client/script/script_edits.h"
#include "client/web/core/front_commands.h"
#include "common/base/text_lines.h"
#include "common/edit/edit_lines.h"
#include "common/edit/preview_change.h"

namespace burnish {

namespace {

using Words = std::vector<std::string>;

/// Returns the words from `first` on.
Words words_from(const FrontWords& line, size_t first) {
  return {line.words.begin() + static_cast<std::ptrdiff_t>(first), line.words.end()};
}

// The pointer draws strokes, and the plot drags the curve.
bool has_preview(const Change& change) {
  return std::holds_alternative<SetControls>(change) ||
         (preview_of(change) && !std::holds_alternative<Stroke>(change) &&
          !std::holds_alternative<SetTransferCurve>(change));
}

Status preview(const ScriptLine& line, Document& document) {
  const Words& words = line.words;
  if (line.command == "preset") {
    ASSIGN_OR_RETURN(const ChosenPreset chosen, parse_preset(words));
    document.preview_strength(chosen.preset, chosen.strength);
  } else if (line.command == "fidelity") {
    ASSIGN_OR_RETURN(const double alpha, parse_real(words[0]));
    RETURN_IF_ERROR(check_alpha(alpha));
    document.curve().set_fidelity(alpha);
    document.preview_curve();
  } else if (!edit_kind_of(line.command)) {
    return invalid_argument("'" + line.command + "' has no preview");
  } else {
    ASSIGN_OR_RETURN(Change change, parse_change(line, document));
    if (!has_preview(change)) return invalid_argument("'" + line.command + "' has no preview");
    document.preview(std::move(change));
  }
  return Status::ok();
}

/// Parses numbers and checks their count.
Result<std::vector<double>> numbers_of(const FrontWords& line, size_t count) {
  if (line.words.size() != count + 1)
    return invalid_argument("'plot " + line.words[0] + "' needs " + std::to_string(count) +
                            " numbers");
  std::vector<double> numbers;
  for (const std::string& word : words_from(line, 1)) {
    ASSIGN_OR_RETURN(const double number, parse_real(word));
    numbers.push_back(number);
  }
  return numbers;
}

/// Takes the point there, or adds one.
Status grab(const std::vector<double>& numbers, Document& document) {
  CurveEditor& editor = document.curve();
  const Eigen::Vector2d place(numbers[0], numbers[1]);
  if (const auto point = editor.point_near(place, {numbers[2], numbers[3]})) {
    editor.begin_drag(*point);
  } else if (editor.add(place)) {
    document.preview_curve();
  }
  return Status::ok();
}

Result<size_t> point_of(const FrontWords& line, const CurveEditor& editor) {
  ASSIGN_OR_RETURN(const std::vector<double> numbers, numbers_of(line, 1));
  if (!(numbers[0] >= 0 && numbers[0] < static_cast<double>(editor.points().size())))
    return invalid_argument("point " + line.words[1] + " of the curve: it has " +
                            std::to_string(editor.points().size()));
  return static_cast<size_t>(numbers[0]);
}

Status plot(const FrontWords& line, Document& document) {
  RETURN_IF_ERROR(need_words(line, 1));
  CurveEditor& editor = document.curve();
  const std::string& what = line.words[0];
  if (what == "grab") {
    ASSIGN_OR_RETURN(const std::vector<double> numbers, numbers_of(line, 4));
    return grab(numbers, document);
  }
  if (what == "drag") {
    ASSIGN_OR_RETURN(const std::vector<double> numbers, numbers_of(line, 2));
    if (!editor.dragged()) return Status::ok();  // an undo may have ended it
    editor.drag_to({numbers[0], numbers[1]});
    document.preview_curve();
  } else if (what == "drop") {
    if (editor.dragged() && editor.end_drag()) document.commit_curve();
  } else if (what == "take") {
    ASSIGN_OR_RETURN(const size_t point, point_of(line, editor));
    editor.begin_drag(point);
  } else if (what == "remove") {
    ASSIGN_OR_RETURN(const size_t point, point_of(line, editor));
    if (editor.remove(point)) document.commit_curve();
  } else {
    return invalid_argument("'" + what + "' is not grab, take, drag, drop or remove");
  }
  return Status::ok();
}

}  // namespace

std::optional<Status> do_preview(const FrontWords& line, Document& document) {
  if (line.command != "preview") return std::nullopt;
  const Status has_words = need_words(line, 1);
  if (!has_words.is_ok()) return has_words;
  Words words = words_from(line, 1);
  if (words.empty() && !edit_kind_of(line.words[0])) return need_words(line, 2);
  return preview({0, line.words[0], std::move(words)}, document);
}

std::optional<Status> do_plot(const FrontWords& line, Document& document) {
  if (line.command != "plot") return std::nullopt;
  return plot(line, document);
}

}  // namespace burnish
