#include "common/mesh/rewrite/patch/text_patch.h"

#include <charconv>
#include <cmath>
#include <string_view>

#include "common/mesh/reading/text_colours.h"

namespace burnish {

/// Replaces a number by the shortest text of a float.
static void replace_number(std::string_view word, double before, double after, BytePatch& patch) {
  const auto number = static_cast<float>(after);
  if (std::isnan(before) || number == static_cast<float>(before)) return;
  char digits[32];
  const auto end = std::to_chars(digits, digits + sizeof digits, number).ptr;
  patch.replace(word, {digits, static_cast<size_t>(end - digits)});
}

Status replace_position(const std::string& name, const WrittenMesh& written, uint64_t vertex,
                        const PositionWords& words, BytePatch& patch) {
  for (int axis = 0; axis < 3; ++axis) {
    const std::string_view word = words[static_cast<size_t>(axis)];
    double before;
    if (!parse_double(word, before))
      return changed_original(name, in_quotes(word) + " is not a coordinate");
    RETURN_IF_ERROR(check_unchanged(written.moved(), name, vertex, axis, before));
    const double after = written.moved().after.vertices[vertex][axis];
    if (!is_coordinate(before) || after == before) continue;
    patch.replace(word, written.axis(static_cast<size_t>(axis)).text_of(after, before, word));
  }
  return Status::ok();
}

static bool parse_three(const PositionWords& words, Vec3d& numbers) {
  for (int i = 0; i < 3; ++i)
    if (!parse_double(words[static_cast<size_t>(i)], numbers[i])) return false;
  return true;
}

std::optional<Vec3f> parse_normal(const PositionWords& words) {
  Vec3d normal;
  if (!parse_three(words, normal)) return std::nullopt;
  return normal.cast<float>();
}

void replace_colour(const Rgba8& colour, float scale, const PositionWords& words,
                    BytePatch& patch) {
  Vec3d before;
  if (!parse_three(words, before)) return;
  for (size_t i = 0; i < 3; ++i) {
    const double channel = before[static_cast<int>(i)];
    if (colour_byte(static_cast<float>(channel), scale) == colour[i]) continue;
    replace_number(words[i], channel, static_cast<float>(colour[i]) / scale, patch);
  }
}

void replace_normal(const AreaVectors& areas, const WrittenNumber& number,
                    const PositionWords& words, BytePatch& patch) {
  Vec3d before;
  if (!parse_three(words, before)) return;
  const Vec3d after = areas.turn(before);
  for (size_t axis = 0; axis < 3; ++axis) {
    const auto i = static_cast<int>(axis);
    if (std::isnan(before[i]) || !number.tells_apart(after[i], before[i])) continue;
    const double kept = number.kept(after[i], before[i]);
    patch.replace(words[axis], number.text_of(kept, before[i], words[axis]));
  }
}

void add_words(const PositionWords& words, TextDigits& digits) {
  for (const std::string_view word : words) digits.add(word);
}

}  // namespace burnish
