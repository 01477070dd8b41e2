#include <string_view>
#include <vector>

#include "common/mesh/off/off.h"
#include "common/mesh/off/off_text.h"
#include "common/mesh/reading/odd_vertices.h"
#include "common/mesh/reading/polygon.h"
#include "common/mesh/reading/text_colours.h"
#include "common/mesh/reading/text_values.h"

namespace burnish {

/// Keeps the positions, colours and faces of an OFF file. Fills a TriangleMesh or a GrowingMesh.
template <typename Mesh>
class OffReader {
 public:
  OffReader(std::span<const uint8_t> bytes, const std::string& name, const FileSteps& steps,
            Mesh& mesh)
      : text_(bytes, name, steps),
        file_bytes_(bytes.size()),
        mesh_(mesh),
        colours_(space_beside(mesh)) {}

  Status read() {
    RETURN_IF_ERROR(text_.read_header());
    mesh_.vertices.resize(text_.vertices(), Vec3d::Zero());
    for (uint64_t v = 0; v < text_.vertices(); ++v) RETURN_IF_ERROR(read_vertex(v));
    mesh_.triangles.reserve(text_.faces());
    for (uint64_t f = 0; f < text_.faces(); ++f) RETURN_IF_ERROR(read_face(f));
    colours_.finish(text_.vertices(), mesh_.colours);
    return odd_.settle({mesh_.vertices.data(), mesh_.vertices.size()},
                       {mesh_.triangles.data(), mesh_.triangles.size()});
  }

 private:
  Status read_vertex(uint64_t v) {
    if (!text_.next_element()) return truncated("vertex", v, text_.vertices());
    const std::string_view x = text_.next_word(), y = text_.next_word();
    RETURN_IF_ERROR(parse_position({x, y, text_.next_word()}, text_.scanner(), {"vertex", v}, &odd_,
                                   mesh_.vertices[v], mesh_.has_double_positions));
    for (int skipped = 0; text_.kind().has_normals && skipped < 3; ++skipped) text_.next_word();
    if (text_.kind().has_colours) read_colour(v);
    return Status::ok();
  }

  void read_colour(uint64_t v) {
    if (const auto rgb = next_colour(text_.scanner())) colours_.set(v, *rgb);
  }

  Status read_face(uint64_t f) {
    if (!text_.next_element()) return truncated("face", f, text_.faces());
    const std::string_view token = text_.next_word();
    int64_t count;
    if (!parse_integer(token, count) || count < 0)
      return text_.scanner().error("face " + std::to_string(f) + ": " + in_quotes(token) +
                                   " is not a number of corners");
    corners_.clear();
    for (int64_t i = 0; i < count; ++i) RETURN_IF_ERROR(read_corner(f, i, count));
    append_fan(corners_, mesh_.triangles);
    if (unfolds_too_far(mesh_.triangles, file_bytes_))
      return text_.scanner().error(unfolding_complaint(mesh_.triangles, file_bytes_));
    return Status::ok();
  }

  Status read_corner(uint64_t f, int64_t i, int64_t count) {
    const std::string_view token = text_.next_word();
    int64_t index;
    if (token.empty())
      return text_.scanner().error("face " + std::to_string(f) + " has " + std::to_string(i) +
                                   " of its " + std::to_string(count) + " corners");
    if (!parse_integer(token, index))
      return text_.scanner().error("face " + std::to_string(f) + ": " + in_quotes(token) +
                                   " is not a vertex number");
    if (index < 0 || static_cast<uint64_t>(index) >= text_.vertices())
      return text_.scanner().error(
          index_complaint("face", f, std::to_string(index), text_.vertices()));
    corners_.push_back(static_cast<uint32_t>(index));
    return Status::ok();
  }

  Status truncated(const std::string& what, uint64_t number, uint64_t count) const {
    return text_.scanner().error("the file ends before " + what + " " + std::to_string(number) +
                                 " of " + std::to_string(count));
  }

  OffText text_;
  uint64_t file_bytes_;
  Mesh& mesh_;
  TextColours colours_;
  OddVertices odd_;
  std::vector<uint32_t> corners_;
};

Result<TriangleMesh> read_off(std::span<const uint8_t> bytes, const std::string& name,
                              const FileSteps& steps) {
  RETURN_IF_ERROR(check_line_lengths(bytes, name, steps));
  TriangleMesh mesh;
  RETURN_IF_ERROR(OffReader(bytes, name, steps, mesh).read());
  return mesh;
}

Status read_off(std::span<const uint8_t> bytes, const std::string& name, const FileSteps& steps,
                GrowingMesh& mesh) {
  RETURN_IF_ERROR(check_line_lengths(bytes, name, steps));
  return OffReader(bytes, name, steps, mesh).read();
}

}  // namespace burnish
