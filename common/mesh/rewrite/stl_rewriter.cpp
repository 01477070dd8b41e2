#include <array>
#include <cmath>
#include <cstring>
#include <string_view>
#include <utility>

#include "common/mesh/reading/text_values.h"
#include "common/mesh/rewrite/format_rewriters.h"
#include "common/mesh/rewrite/patch/text_patch.h"
#include "common/mesh/stl/stl_layout.h"

namespace burnish {

namespace {

Status other_facets(const std::string& name, uint64_t facets, const MovedMesh& moved) {
  return changed_original(name, "it has " + std::to_string(facets) + " facets, it had " +
                                    std::to_string(moved.after.triangles.size()));
}

AreaVectors area_of_facet(const MovedMesh& moved, uint64_t facet) {
  AreaVectors area;
  area.add(moved, moved.after.triangles[facet]);
  return area;
}

/// Replaces those of three floats that differ.
void replace_floats(std::string_view piece, const Vec3f& before, const Vec3f& after,
                    BytePatch& patch) {
  for (int axis = 0; axis < 3; ++axis) {
    if (std::isnan(before[axis]) || before[axis] == after[axis]) continue;
    const auto* bytes = reinterpret_cast<const char*>(after.data() + axis);
    patch.replace(piece.substr(axis * sizeof(float), sizeof(float)), {bytes, sizeof(float)});
  }
}

Status rewrite_binary_facet(std::string_view facet, uint64_t number, const std::string& name,
                            const MovedMesh& moved, BytePatch& patch) {
  std::array<float, 12> numbers;  // of the normal, then of the corners
  std::memcpy(numbers.data(), facet.data(), sizeof numbers);
  const auto value = [&](size_t i) { return Vec3f(numbers.data() + 3 * i); };
  const auto piece = [&](size_t i) { return facet.substr(i * sizeof(Vec3f), sizeof(Vec3f)); };
  const Vec3d normal = area_of_facet(moved, number).turn(value(0).cast<double>());
  replace_floats(piece(0), value(0), normal.cast<float>(), patch);
  for (size_t corner = 0; corner < 3; ++corner) {
    const uint32_t vertex = moved.after.triangles[number][corner];
    const Vec3f before = value(corner + 1);
    for (int axis = 0; axis < 3; ++axis)
      RETURN_IF_ERROR(check_unchanged(moved, name, vertex, axis, double{before[axis]}));
    replace_floats(piece(corner + 1), before, moved.after.vertices[vertex].cast<float>(), patch);
  }
  return Status::ok();
}

Status rewrite_binary(std::span<const uint8_t> bytes, const std::string& name,
                      const MovedMesh& moved, OutputBuffer& output) {
  const uint64_t facets = moved.after.triangles.size();
  const uint64_t promised = bytes.size() < kStlHeaderBytes ? 0 : promised_stl_bytes(bytes);
  if (promised != kStlHeaderBytes + facets * kStlFacetBytes || promised > bytes.size())
    return other_facets(name, bytes.size() / kStlFacetBytes, moved);
  BytePatch patch(bytes, output);
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  for (uint64_t facet = 0; facet < facets; ++facet)
    RETURN_IF_ERROR(
        rewrite_binary_facet(text.substr(kStlHeaderBytes + facet * kStlFacetBytes, kStlFacetBytes),
                             facet, name, moved, patch));
  patch.finish();
  return Status::ok();
}

struct StlDigits {
  TextDigits positions, normals;
};

/// Takes words that follow "vertex" and "normal" outside a solid too: they do no harm.
StlDigits stl_digits_of(std::span<const uint8_t> bytes, const FileSteps& steps) {
  StlDigits digits;
  for (TextScanner scanner(bytes, "", {}, 0, steps); scanner.next_line();) {
    const std::string keyword = next_stl_keyword(scanner);
    if (keyword == "vertex") add_words(next_position_words(scanner), digits.positions);
    if (keyword == "facet" && equals_ignoring_case(scanner.next_token(), "normal"))
      add_words(next_position_words(scanner), digits.normals);
  }
  return digits;
}

/// Follows the statements as AsciiStlReader does.
class AsciiStlRewriter {
 public:
  AsciiStlRewriter(std::span<const uint8_t> bytes, const std::string& name,
                   const WrittenMesh& written, WrittenNumber normal_number, OutputBuffer& output)
      : text_{TextScanner(bytes, name, {}, 0, FileSteps(output.budget())),
              BytePatch(bytes, output)},
        name_(name),
        written_(written),
        normal_number_(std::move(normal_number)),
        moved_(written.moved()) {}

  Status rewrite() {
    while (text_.scanner.next_line()) {
      const std::string keyword = next_stl_keyword(text_.scanner);
      if (!in_solid_) {
        in_solid_ = keyword == "solid";
      } else if (keyword == "facet") {
        rewrite_facet_normal();
      } else if (keyword == "vertex") {
        RETURN_IF_ERROR(rewrite_corner());
      } else if (keyword == "endfacet") {
        ++facet_;
        corner_ = 0;
      } else if (keyword == "endsolid") {
        in_solid_ = false;
      }
    }
    if (facet_ != moved_.after.triangles.size()) return other_facets(name_, facet_, moved_);
    text_.patch.finish();
    return Status::ok();
  }

 private:
  void rewrite_facet_normal() {
    if (facet_ >= moved_.after.triangles.size()) return;
    if (equals_ignoring_case(text_.scanner.next_token(), "normal"))
      replace_normal(area_of_facet(moved_, facet_), normal_number_,
                     next_position_words(text_.scanner), text_.patch);
  }

  Status rewrite_corner() {
    if (facet_ >= moved_.after.triangles.size() || corner_ >= 3)
      return other_facets(name_, facet_ + 1, moved_);
    return replace_position(name_, written_, moved_.after.triangles[facet_][corner_++],
                            next_position_words(text_.scanner), text_.patch);
  }

  TextPatch text_;
  const std::string& name_;
  const WrittenMesh& written_;
  const WrittenNumber normal_number_;
  const MovedMesh& moved_;
  bool in_solid_ = false;
  uint64_t facet_ = 0;
  size_t corner_ = 0;
};

Status rewrite_text(std::span<const uint8_t> bytes, const std::string& name, const MovedMesh& moved,
                    OutputBuffer& output) {
  const StlDigits digits = stl_digits_of(bytes, FileSteps(output.budget()));
  const WrittenMesh written(moved, WrittenNumber::of_text(moved, digits.positions));
  return AsciiStlRewriter(bytes, name, written, WrittenNumber::of_normals(digits.normals), output)
      .rewrite();
}

}  // namespace

Status rewrite_stl(std::span<const uint8_t> bytes, const std::string& name, const MovedMesh& moved,
                   OutputBuffer& output) {
  if (is_stl_text(bytes)) return rewrite_text(bytes, name, moved, output);
  const WrittenMesh written(moved, WrittenNumber{.type = PlyType::kFloat32, .digits = {}});
  return rewrite_binary(bytes, name, written.moved(), output);
}

}  // namespace burnish
