#include "common/edit/edit_words.h"

#include <cctype>

#include "common/base/fixed_text.h"

namespace burnish {
namespace {

std::string number_in_words(double x) {
  constexpr int kDigits = 3;
  return fixed_text(x, kDigits);
}

std::string points_in_words(size_t count) {
  return std::to_string(count) + (count == 1 ? " point" : " points");
}

std::string mode_name(double value, const char* less, const char* more) {
  return value == 1 ? "Restore" : value < 1 ? less : more;
}

// The verbs are those of the brush's panel.
std::string stroke_name(const Brush& brush) {
  if (brush.band > 0) return "Stroke of band " + std::to_string(brush.band);
  if (brush.curve > 0) return "Stroke of curve " + std::to_string(brush.curve);
  if (brush.edges) return brush.beta > 0 ? "Denoise stroke" : "Keep stroke";
  if (brush.texture) return mode_name(brush.beta, "Fade", "Strengthen") + " texture stroke";
  return mode_name(brush.beta, "Smooth", "Sharpen") +
         (brush.colour ? " colours stroke" : " stroke");
}

std::string painted_value(const Brush& brush) {
  if (brush.curve > 0) return {};
  const char* const what = brush.band > 0 || brush.texture ? "gain "
                           : brush.edges                   ? "strength of kept edges "
                                                           : "β ";
  return what + number_in_words(brush.beta) + ", ";
}

/// A kind without words of its own has its summary for a name.
struct WordsOfChange {
  const Edit& edit;

  EditWords operator()(const Stroke& stroke) const {
    const Brush& brush = stroke.brush;
    return {stroke_name(brush),
            painted_value(brush) + "brush strength " + number_in_words(brush.strength) + ", " +
                points_in_words(stroke.path.size()) + (brush.connected ? "" : ", through walls"),
            brush.radius};
  }
  EditWords operator()(const SetGradientScale& change) const {
    return {"Gradient scale " + number_in_words(change.beta), ""};
  }
  EditWords operator()(const SetTransferCurve& change) const {
    const auto& points = change.curve.points();
    if (change.curve.is_constant())
      return {"Fidelity α " + number_in_words(points.front().alpha), ""};
    return {"Transfer curve", points_in_words(points.size()) + ", contrast " +
                                  number_in_words(change.curve.contrast())};
  }
  EditWords operator()(const Protect& change) const {
    const std::string verb = change.release ? "Release" : "Protect";
    if (const auto* lasso = std::get_if<LassoRegion>(&change.way))
      return {verb + " by lasso",
              points_in_words(lasso->polygon.size()) + (lasso->through ? ", through" : "")};
    if (const auto* range = std::get_if<CurvatureRegion>(&change.way))
      return {verb + " by curvature",
              number_in_words(range->least) + " to " + number_in_words(range->most)};
    return summary_as_name();
  }
  EditWords operator()(const SetControls&) const { return {"Limits", summary(edit)}; }
  EditWords operator()(const SetEqualiser&) const { return {"Equaliser", summary(edit)}; }
  EditWords operator()(const SetColour&) const { return {"Colours", summary(edit)}; }
  EditWords operator()(const SetTexture&) const { return {"Texture", summary(edit)}; }
  EditWords operator()(const SetEdges& change) const {
    if (!change.filter.is_on()) return summary_as_name();
    return {"Keep edges", summary(edit)};
  }
  EditWords operator()(const SetCheckpoint& change) const { return {change.name, ""}; }
  EditWords operator()(const Damaged& change) const { return {"Damaged edit", change.reason}; }
  template <typename Change>
  EditWords operator()(const Change&) const {
    return summary_as_name();
  }

  EditWords summary_as_name() const {
    std::string name = summary(edit);
    if (!name.empty())
      name[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(name[0])));
    return {std::move(name), ""};
  }
};

}  // namespace

EditWords words_of(const Edit& edit) {
  return std::visit(WordsOfChange{edit}, edit.change);
}

}  // namespace burnish
