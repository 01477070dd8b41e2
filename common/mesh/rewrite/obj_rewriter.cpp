#include <algorithm>
#include <string_view>

#include "common/mesh/reading/text_colours.h"
#include "common/mesh/rewrite/format_rewriters.h"
#include "common/mesh/rewrite/obj_normals.h"
#include "common/mesh/rewrite/patch/text_patch.h"

namespace burnish {

std::optional<float> obj_colour_scale(std::span<const uint8_t> bytes, const FileSteps& steps) {
  TextScanner scanner(bytes, "", kObjSyntax, 0, steps);
  std::optional<float> largest;
  while (scanner.next_line()) {
    if (scanner.next_token() != "v") continue;
    for (int axis = 0; axis < 3; ++axis) scanner.next_token();
    if (const auto rgb = next_colour(scanner)) largest = largest_channel(largest.value_or(0), *rgb);
  }
  return largest ? std::optional(colour_scale(*largest)) : std::nullopt;
}

struct ObjDigits {
  TextDigits positions, normals;
};

static ObjDigits obj_digits_of(std::span<const uint8_t> bytes, const FileSteps& steps) {
  ObjDigits digits;
  for (TextScanner scanner(bytes, "", kObjSyntax, 0, steps); scanner.next_line();) {
    const std::string_view keyword = scanner.next_token();
    if (keyword == "v") add_words(next_position_words(scanner), digits.positions);
    if (keyword == "vn") add_words(next_position_words(scanner), digits.normals);
  }
  return digits;
}

Status rewrite_obj(std::span<const uint8_t> bytes, const std::string& name, const MovedMesh& moved,
                   OutputBuffer& output) {
  const FileSteps steps(output.budget());
  const ObjDigits digits = obj_digits_of(bytes, steps);
  const WrittenMesh written(moved, WrittenNumber::of_text(moved, digits.positions));
  const WrittenNumber normal_number = WrittenNumber::of_normals(digits.normals);
  const std::vector<AreaVectors> normals = gather_obj_normals(bytes, written.moved(), steps);
  const bool has_colours = moved.after.has_colours();
  const float scale = has_colours ? obj_colour_scale(bytes, steps).value_or(0) : 0;
  TextPatch text = {TextScanner(bytes, name, kObjSyntax, 0, steps), BytePatch(bytes, output)};
  uint64_t vertex = 0;
  size_t normal = 0;
  while (text.scanner.next_line()) {
    const std::string_view keyword = text.scanner.next_token();
    if (keyword == "v") {
      const PositionWords words = next_position_words(text.scanner);
      RETURN_IF_ERROR(replace_position(name, written, vertex, words, text.patch));
      if (scale > 0)
        replace_colour(moved.after.colours[vertex], scale, next_position_words(text.scanner),
                       text.patch);
      ++vertex;
    }
    if (keyword == "vn")
      replace_normal(normals[normal++], normal_number, next_position_words(text.scanner),
                     text.patch);
  }
  if (vertex != moved.before.size())
    return changed_original(name, "it has " + std::to_string(vertex) + " vertices, it had " +
                                      std::to_string(moved.before.size()));
  text.patch.finish();
  return Status::ok();
}

}  // namespace burnish
