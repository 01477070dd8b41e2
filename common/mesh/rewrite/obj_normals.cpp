#include "common/mesh/rewrite/obj_normals.h"

#include <optional>
#include <string_view>

#include "common/mesh/text_values.h"

namespace burnish {

namespace {

size_t count_normals(std::span<const uint8_t> bytes) {
  size_t normals = 0;
  for (TextScanner scanner(bytes, "", kObjSyntax); scanner.next_line();)
    normals += scanner.next_token() == "vn";
  return normals;
}

/// Returns the place that an OBJ index means: from 1, or back from the last of those so far.
std::optional<size_t> place_of(std::string_view token, size_t so_far, size_t all) {
  int64_t index;
  if (!parse_integer(token, index)) return std::nullopt;
  const int64_t place = index < 0 ? static_cast<int64_t>(so_far) + index : index - 1;
  if (place < 0 || static_cast<uint64_t>(place) >= all) return std::nullopt;
  return static_cast<size_t>(place);
}

class NormalGatherer {
 public:
  NormalGatherer(std::span<const uint8_t> bytes, const MovedMesh& moved, size_t normals)
      : scanner_(bytes, "", kObjSyntax), moved_(moved), areas_(normals) {}

  std::vector<AreaVectors> gather() {
    while (scanner_.next_line()) {
      const std::string_view keyword = scanner_.next_token();
      if (keyword == "v") ++vertices_;
      if (keyword == "vn") ++normals_;
      if (keyword == "f") add_face();
    }
    return std::move(areas_);
  }

 private:
  void add_face() {
    corners_.clear();
    used_.clear();
    for (std::string_view token; !(token = scanner_.next_token()).empty();) add_corner(token);
    AreaVectors face;
    for (size_t i = 2; i < corners_.size(); ++i)
      face.add(moved_, {corners_[0], corners_[i - 1], corners_[i]});
    for (const size_t normal : used_) {
      areas_[normal].before += face.before;
      areas_[normal].after += face.after;
    }
  }

  /// Reads "v/vt/vn" or "v//vn"; a corner without a normal is part of the face too.
  void add_corner(std::string_view token) {
    const size_t slash = token.find('/');
    const auto vertex = place_of(token.substr(0, slash), vertices_, moved_.before.size());
    if (vertex) corners_.push_back(static_cast<uint32_t>(*vertex));
    const size_t last = token.rfind('/');
    if (last == slash) return;
    const auto normal = place_of(token.substr(last + 1), normals_, areas_.size());
    if (normal) used_.push_back(*normal);
  }

  TextScanner scanner_;
  const MovedMesh& moved_;
  std::vector<AreaVectors> areas_;
  std::vector<uint32_t> corners_;  // of the current face
  std::vector<size_t> used_;       // normals of the current face
  size_t vertices_ = 0;
  size_t normals_ = 0;
};

}  // namespace

std::vector<AreaVectors> gather_obj_normals(std::span<const uint8_t> bytes,
                                            const MovedMesh& moved) {
  const size_t normals = count_normals(bytes);
  if (normals == 0) return {};
  return NormalGatherer(bytes, moved, normals).gather();
}

}  // namespace burnish
