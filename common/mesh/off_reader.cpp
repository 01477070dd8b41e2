#include <optional>
#include <string_view>
#include <vector>

#include "common/base/limits.h"
#include "common/mesh/mesh_formats.h"
#include "common/mesh/off_kind.h"
#include "common/mesh/polygon.h"
#include "common/mesh/text_colours.h"
#include "common/mesh/text_scanner.h"
#include "common/mesh/text_values.h"

namespace burnish {

/// Reads Geomview's OFF and its variants with colours (C), normals (N) and texture coordinates
/// (ST). Keeps only the colours. A vertex or face has one line. Fills a TriangleMesh or a
/// GrowingMesh.
template <typename Mesh>
class OffReader {
 public:
  OffReader(std::span<const uint8_t> bytes, const std::string& name, Mesh& mesh)
      : scanner_(bytes, name, {.hash_comments = true}),
        file_bytes_(bytes.size()),
        mesh_(mesh),
        colours_(space_beside(mesh)) {}

  Status read() {
    RETURN_IF_ERROR(read_magic());
    RETURN_IF_ERROR(read_counts());
    mesh_.vertices.resize(vertices_, Vec3d::Zero());
    for (uint64_t v = 0; v < vertices_; ++v) RETURN_IF_ERROR(read_vertex(v));
    mesh_.triangles.reserve(faces_);
    for (uint64_t f = 0; f < faces_; ++f) RETURN_IF_ERROR(read_face(f));
    colours_.finish(vertices_, mesh_.colours);
    return Status::ok();
  }

 private:
  Status read_magic() {
    const std::string_view magic = scanner_.next_line() ? scanner_.next_token() : "";
    const std::optional<OffKind> kind = parse_off_kind(magic);
    kind_ = kind.value_or(OffKind());
    if (kind) return Status::ok();
    return scanner_.error("not an OFF file: begins with " + in_quotes(magic) +
                          ", not OFF, COFF, NOFF or CNOFF");
  }

  /// Reads "vertices faces [edges]", after the magic word or on its own line.
  Status read_counts() {
    std::string_view token = scanner_.next_token();
    if (token == "BINARY") return scanner_.error("binary OFF files cannot be read; only text");
    if (token.empty() && scanner_.next_line()) token = scanner_.next_token();
    RETURN_IF_ERROR(parse_count("vertex", token, kVerticesMax, vertices_));
    RETURN_IF_ERROR(parse_count("face", scanner_.next_token(), kTrianglesMax, faces_));
    // The shortest lines are "0 0 0" and "0"; all lines but the last have a line end.
    const uint64_t bytes_min = 6 * vertices_ + 2 * faces_;
    const uint64_t bytes = scanner_.bytes_after_line();
    if (bytes_min <= bytes + 1) return Status::ok();
    return scanner_.error("the header promises " + std::to_string(vertices_) + " vertices and " +
                          std::to_string(faces_) + " faces, at least " +
                          std::to_string(bytes_min - 1) + " bytes, but only " +
                          std::to_string(bytes) + " follow");
  }

  Status parse_count(const std::string& what, std::string_view token, uint64_t limit,
                     uint64_t& count) {
    int64_t value;
    if (!parse_integer(token, value))
      return scanner_.error("the " + what + " count " + in_quotes(token) + " is not a count");
    if (value < 0 || static_cast<uint64_t>(value) > limit)
      return scanner_.error("the " + what + " count " + std::to_string(value) +
                            " is outside 0 to " + std::to_string(limit));
    count = static_cast<uint64_t>(value);
    return Status::ok();
  }

  Status read_vertex(uint64_t v) {
    if (!scanner_.next_line()) return truncated("vertex", v, vertices_);
    RETURN_IF_ERROR(
        read_position(scanner_, {"vertex", v}, mesh_.vertices[v], mesh_.has_double_positions));
    for (int skipped = 0; kind_.has_normals && skipped < 3; ++skipped) scanner_.next_token();
    if (kind_.has_colours) read_colour(v);
    return Status::ok();
  }

  void read_colour(uint64_t v) {
    if (const auto rgb = next_colour(scanner_)) colours_.set(v, *rgb);
  }

  Status read_face(uint64_t f) {
    if (!scanner_.next_line()) return truncated("face", f, faces_);
    const std::string_view token = scanner_.next_token();
    int64_t count;
    if (!parse_integer(token, count))
      return scanner_.error("face " + std::to_string(f) + ": " + in_quotes(token) +
                            " is not a number of corners");
    if (count < 3) return scanner_.error(corner_count_complaint(f, count));
    corners_.clear();
    for (int64_t i = 0; i < count; ++i) RETURN_IF_ERROR(read_corner(f, i, count));
    append_fan(corners_, mesh_.triangles);
    if (unfolds_too_far(mesh_.triangles, file_bytes_))
      return scanner_.error(unfolding_complaint(mesh_.triangles, file_bytes_));
    return Status::ok();
  }

  Status read_corner(uint64_t f, int64_t i, int64_t count) {
    const std::string_view token = scanner_.next_token();
    int64_t index;
    if (token.empty())
      return scanner_.error("face " + std::to_string(f) + " has " + std::to_string(i) + " of its " +
                            std::to_string(count) + " corners");
    if (!parse_integer(token, index))
      return scanner_.error("face " + std::to_string(f) + ": " + in_quotes(token) +
                            " is not a vertex number");
    if (index < 0 || static_cast<uint64_t>(index) >= vertices_)
      return scanner_.error(index_complaint("face", f, std::to_string(index), vertices_));
    corners_.push_back(static_cast<uint32_t>(index));
    return Status::ok();
  }

  Status truncated(const std::string& what, uint64_t number, uint64_t count) const {
    return scanner_.error("the file ends before " + what + " " + std::to_string(number) + " of " +
                          std::to_string(count));
  }

  TextScanner scanner_;
  uint64_t file_bytes_;
  Mesh& mesh_;
  TextColours colours_;
  std::vector<uint32_t> corners_;
  uint64_t vertices_ = 0;
  uint64_t faces_ = 0;
  OffKind kind_;
};

Result<TriangleMesh> read_off(std::span<const uint8_t> bytes, const std::string& name) {
  RETURN_IF_ERROR(check_line_lengths(bytes, name));
  TriangleMesh mesh;
  RETURN_IF_ERROR(OffReader(bytes, name, mesh).read());
  return mesh;
}

Status read_off(std::span<const uint8_t> bytes, const std::string& name, GrowingMesh& mesh) {
  RETURN_IF_ERROR(check_line_lengths(bytes, name));
  return OffReader(bytes, name, mesh).read();
}

}  // namespace burnish
