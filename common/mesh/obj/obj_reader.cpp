#include <string_view>
#include <vector>

#include "common/base/limits.h"
#include "common/mesh/obj/obj.h"
#include "common/mesh/reading/odd_vertices.h"
#include "common/mesh/reading/polygon.h"
#include "common/mesh/reading/text_colours.h"
#include "common/mesh/reading/text_scanner.h"
#include "common/mesh/reading/text_values.h"

namespace burnish {

/// Reads the statements `v` and `f` of a Wavefront OBJ file and skips all others. Fills a
/// TriangleMesh or a GrowingMesh.
template <typename Mesh>
class ObjReader {
 public:
  ObjReader(std::span<const uint8_t> bytes, const std::string& name, const FileSteps& steps,
            Mesh& mesh)
      : scanner_(bytes, name, {.hash_comments = true, .backslash_continues = true}, 0, steps),
        name_(name),
        file_bytes_(bytes.size()),
        mesh_(mesh),
        colours_(space_beside(mesh)) {}

  Status read() {
    while (scanner_.next_line()) {
      const std::string_view keyword = scanner_.next_token();
      if (keyword == "v") RETURN_IF_ERROR(read_vertex());
      if (keyword == "f") RETURN_IF_ERROR(read_face());
    }
    RETURN_IF_ERROR(check_largest_index());
    RETURN_IF_ERROR(odd_.settle({mesh_.vertices.data(), mesh_.vertices.size()},
                                {mesh_.triangles.data(), mesh_.triangles.size()}));
    colours_.finish(mesh_.vertices.size(), mesh_.colours);
    return Status::ok();
  }

 private:
  Status read_vertex() {
    Vec3d position;
    RETURN_IF_ERROR(parse_position(next_position_words(scanner_), scanner_,
                                   {"vertex", mesh_.vertices.size()}, &odd_, position,
                                   mesh_.has_double_positions));
    read_colour();
    mesh_.vertices.push_back(position);
    return Status::ok();
  }

  /// Reads the colour of "x y z r g b". A single value after x y z is a weight, which is ignored.
  void read_colour() {
    if (const auto rgb = next_colour(scanner_)) colours_.set(mesh_.vertices.size(), *rgb);
  }

  Status read_face() {
    corners_.clear();
    for (std::string_view token; !(token = scanner_.next_token()).empty();) {
      uint32_t corner;
      RETURN_IF_ERROR(read_corner(token, corner));
      corners_.push_back(corner);
    }
    append_fan(corners_, mesh_.triangles);
    if (unfolds_too_far(mesh_.triangles, file_bytes_))
      return scanner_.error(unfolding_complaint(mesh_.triangles, file_bytes_));
    ++faces_;
    return Status::ok();
  }

  /// Reads "v", "v/vt", "v//vn" or "v/vt/vn". v counts from 1; a negative v counts back from the
  /// last vertex.
  Status read_corner(std::string_view token, uint32_t& corner) {
    int64_t index;
    if (!parse_integer(token.substr(0, token.find('/')), index))
      return scanner_.error(face_text() + in_quotes(token) + " is not a corner such as 7 or 7/2/5");
    const auto vertices = static_cast<int64_t>(mesh_.vertices.size());
    const int64_t from_zero = index < 0 ? vertices + index : index - 1;
    if (index == 0) return scanner_.error(face_text() + "vertex 0; OBJ counts vertices from 1");
    if (from_zero < 0)
      return scanner_.error(face_text() + "vertex " + std::to_string(index) + ", but only " +
                            std::to_string(vertices) + " come before it");
    if (static_cast<uint64_t>(from_zero) >= kVerticesMax)
      return scanner_.error(face_text() + "vertex " + std::to_string(index) + ", the limit is " +
                            std::to_string(kVerticesMax));
    if (from_zero > largest_index_) {
      largest_index_ = from_zero;
      largest_index_place_ = {scanner_.line_number(), faces_};
    }
    corner = static_cast<uint32_t>(from_zero);
    return Status::ok();
  }

  /// Runs at the end, when all vertices are known: faces may come before their vertices.
  Status check_largest_index() const {
    if (largest_index_ < static_cast<int64_t>(mesh_.vertices.size())) return Status::ok();
    return invalid_argument(name_ + ": line " + std::to_string(largest_index_place_.line) +
                            ": face " + std::to_string(largest_index_place_.face) +
                            " refers to vertex " + std::to_string(largest_index_ + 1) +
                            ", but there are " + std::to_string(mesh_.vertices.size()));
  }

  std::string face_text() const { return "face " + std::to_string(faces_) + " refers to "; }

  struct Place {
    size_t line = 0;
    uint64_t face = 0;
  };

  TextScanner scanner_;
  std::string name_;
  uint64_t file_bytes_;
  Mesh& mesh_;
  TextColours colours_;
  OddVertices odd_;
  std::vector<uint32_t> corners_;
  uint64_t faces_ = 0;
  int64_t largest_index_ = -1;
  Place largest_index_place_;
};

Result<TriangleMesh> read_obj(std::span<const uint8_t> bytes, const std::string& name,
                              const FileSteps& steps) {
  RETURN_IF_ERROR(check_line_lengths(bytes, name, steps));
  TriangleMesh mesh;
  RETURN_IF_ERROR(ObjReader(bytes, name, steps, mesh).read());
  return mesh;
}

Status read_obj(std::span<const uint8_t> bytes, const std::string& name, const FileSteps& steps,
                GrowingMesh& mesh) {
  RETURN_IF_ERROR(check_line_lengths(bytes, name, steps));
  return ObjReader(bytes, name, steps, mesh).read();
}

}  // namespace burnish
