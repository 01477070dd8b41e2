#include "common/mesh/rewrite/obj_normals.h"

#include <optional>
#include <string_view>

#include "common/mesh/reading/text_values.h"
#include "common/mesh/rewrite/moved/placed_normals.h"
#include "common/mesh/rewrite/patch/text_patch.h"

namespace burnish {

namespace {

/// A normal that cannot be read is 0, which no other equals.
std::vector<Vec3f> read_normals(std::span<const uint8_t> bytes, const FileSteps& steps) {
  std::vector<Vec3f> normals;
  for (TextScanner scanner(bytes, "", kObjSyntax, 0, steps); scanner.next_line();)
    if (scanner.next_token() == "vn")
      normals.push_back(parse_normal(next_position_words(scanner)).value_or(Vec3f::Zero()));
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
  NormalGatherer(std::span<const uint8_t> bytes, const MovedMesh& moved,
                 const std::vector<Vec3f>& values, const FileSteps& steps)
      : scanner_(bytes, "", kObjSyntax, 0, steps),
        moved_(moved),
        values_(values),
        vertex_places_(find_places(moved.before)),
        places_(values.size(), kNoPlace),
        areas_(values.size()) {}

  std::vector<AreaVectors> gather() {
    while (scanner_.next_line()) {
      const std::string_view keyword = scanner_.next_token();
      if (keyword == "v") ++vertices_;
      if (keyword == "vn") ++normals_;
      if (keyword == "f") add_face();
    }
    for (uint32_t& place : places_)
      if (place == kSeveralPlaces) place = kNoPlace;
    share_areas(places_, values_, areas_);
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
    if (normal && vertex) note_place(places_[*normal], vertex_places_.of_vertex[*vertex]);
  }

  /// A normal of several places is that of a face, or of all faces that look the same way. It has
  /// no place of its own.
  static void note_place(uint32_t& of_normal, uint32_t of_vertex) {
    if (of_normal == kNoPlace) of_normal = of_vertex;
    if (of_normal != of_vertex) of_normal = kSeveralPlaces;
  }

  static constexpr uint32_t kSeveralPlaces = kNoPlace - 1;

  TextScanner scanner_;
  const MovedMesh& moved_;
  const std::vector<Vec3f>& values_;
  const Places vertex_places_;
  std::vector<uint32_t> places_;  // by normal
  std::vector<AreaVectors> areas_;
  std::vector<uint32_t> corners_;  // of the current face
  std::vector<size_t> used_;       // normals of the current face
  size_t vertices_ = 0;
  size_t normals_ = 0;
};

}  // namespace

std::vector<AreaVectors> gather_obj_normals(std::span<const uint8_t> bytes, const MovedMesh& moved,
                                            const FileSteps& steps) {
  const std::vector<Vec3f> normals = read_normals(bytes, steps);
  if (normals.empty()) return {};
  return NormalGatherer(bytes, moved, normals, steps).gather();
}

}  // namespace burnish
