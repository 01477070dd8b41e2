#include "common/mesh/rewrite/text_patch.h"

#include <array>
#include <charconv>
#include <cmath>
#include <string_view>

#include "common/mesh/text_colours.h"
#include "common/mesh/text_values.h"

namespace burnish {

template <typename Number>
static void replace_number(std::string_view token, double before, double after, TextPatch& text) {
  const auto number = static_cast<Number>(after);
  if (std::isnan(before) || number == static_cast<Number>(before)) return;
  char digits[32];
  const auto end = std::to_chars(digits, digits + sizeof digits, number).ptr;
  text.patch.replace(token, {digits, static_cast<size_t>(end - digits)});
}

Status replace_position(const std::string& name, const MovedMesh& moved, uint64_t vertex,
                        TextPatch& text) {
  for (int axis = 0; axis < 3; ++axis) {
    const std::string_view token = text.scanner.next_token();
    double before;
    if (!parse_double(token, before))
      return changed_original(name, in_quotes(token) + " is not a coordinate");
    RETURN_IF_ERROR(check_unchanged(moved, name, vertex, axis, before));
    const double after = moved.after.vertices[vertex][axis];
    if (moved.after.has_double_positions) {
      replace_number<double>(token, before, after, text);
    } else {
      replace_number<float>(token, before, after, text);
    }
  }
  return Status::ok();
}

/// Takes the next three words of the line. Returns false unless all are numbers.
static bool take_three(TextPatch& text, std::array<std::string_view, 3>& tokens, Vec3d& numbers) {
  for (std::string_view& token : tokens) token = text.scanner.next_token();
  for (int i = 0; i < 3; ++i)
    if (!parse_double(tokens[static_cast<size_t>(i)], numbers[i])) return false;
  return true;
}

void replace_colour(const Rgba8& colour, float scale, TextPatch& text) {
  std::array<std::string_view, 3> tokens;
  Vec3d before;
  if (!take_three(text, tokens, before)) return;
  for (size_t i = 0; i < 3; ++i) {
    const double channel = before[static_cast<int>(i)];
    if (colour_byte(static_cast<float>(channel), scale) == colour[i]) continue;
    replace_number<float>(tokens[i], channel, static_cast<float>(colour[i]) / scale, text);
  }
}

void replace_normal(const AreaVectors& areas, TextPatch& text) {
  std::array<std::string_view, 3> tokens;
  Vec3d before;
  if (!take_three(text, tokens, before)) return;
  const Vec3d after = areas.turn(before);
  for (size_t axis = 0; axis < 3; ++axis) {
    const auto i = static_cast<int>(axis);
    replace_number<float>(tokens[axis], before[i], after[i], text);
  }
}

}  // namespace burnish
