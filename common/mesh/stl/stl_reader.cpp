#include <cstring>
#include <string_view>

#include "common/mesh/reading/text_scanner.h"
#include "common/mesh/reading/text_values.h"
#include "common/mesh/reading/vertex_welder.h"
#include "common/mesh/stl/stl.h"
#include "common/mesh/stl/stl_layout.h"

namespace burnish {

template <typename Mesh>
static Status read_binary(std::span<const uint8_t> bytes, const std::string& name, FileSteps steps,
                          Mesh& mesh) {
  if (bytes.size() < kStlHeaderBytes)
    return invalid_argument(name + ": neither text that begins with 'solid' nor a whole binary " +
                            "STL file: the header has 84 bytes, the file has " +
                            std::to_string(bytes.size()));
  const uint64_t facets = (promised_stl_bytes(bytes) - kStlHeaderBytes) / kStlFacetBytes;
  if (promised_stl_bytes(bytes) > bytes.size())
    return invalid_argument(
        name + ": neither text that begins with 'solid' nor a whole binary " +
        "STL file: the header promises " + std::to_string(facets) + " facets, " +
        std::to_string(promised_stl_bytes(bytes)) + " bytes, but the file has " +
        std::to_string(bytes.size()) + "; facet " +
        std::to_string((bytes.size() - kStlHeaderBytes) / kStlFacetBytes) + " is not complete");
  mesh.triangles.resize(facets, Triangle());
  VertexWelder welder(mesh.vertices, space_beside(mesh));
  for (uint64_t facet = 0; facet < facets; ++facet) {
    steps.take();
    float corners[3][3];
    const size_t offset = kStlHeaderBytes + facet * kStlFacetBytes + kStlNormalBytes;
    std::memcpy(corners, bytes.data() + offset, sizeof corners);
    for (int corner = 0; corner < 3; ++corner) {
      const float* p = corners[corner];
      for (int axis = 0; axis < 3; ++axis) {
        if (is_coordinate(p[axis])) continue;
        return invalid_argument(name + ": byte " + std::to_string(offset) + ": " +
                                coordinate_complaint({"facet", facet}, axis, number_text(p[axis])));
      }
      mesh.triangles[facet][corner] = welder.index_of(Vec3d(p[0], p[1], p[2]));
    }
  }
  return Status::ok();
}

/// Reads one or several solids; skips text outside them. Fills a TriangleMesh or a GrowingMesh.
template <typename Mesh>
class AsciiStlReader {
 public:
  AsciiStlReader(std::span<const uint8_t> bytes, const std::string& name, const FileSteps& steps,
                 Mesh& mesh)
      : scanner_(bytes, name, {}, 0, steps),
        mesh_(mesh),
        welder_(mesh.vertices, space_beside(mesh)) {}

  Status read() {
    while (scanner_.next_line()) {
      const std::string keyword = next_stl_keyword(scanner_);
      if (in_solid_) {
        RETURN_IF_ERROR(read_statement(keyword));
      } else {
        in_solid_ = keyword == "solid";
      }
    }
    if (in_solid_)
      return scanner_.error("the file ends in facet " + std::to_string(mesh_.triangles.size()) +
                            " or without 'endsolid'");
    return Status::ok();
  }

 private:
  Status read_statement(const std::string& keyword) {
    if (keyword == "vertex") return read_corner();
    if (keyword == "endfacet") return end_facet();
    if (keyword == "outer" || keyword == "endloop") return Status::ok();
    const bool is_facet = keyword == "facet";
    if (!is_facet && keyword != "endsolid")
      return scanner_.error(in_quotes(keyword) + " is not a statement of an STL solid");
    if (corners_ != 0)
      return scanner_.error(facet_text() + " has no 'endfacet' before " + in_quotes(keyword));
    in_solid_ = is_facet;
    return Status::ok();
  }

  Status read_corner() {
    if (corners_ == 3) return scanner_.error(facet_text() + " has more than 3 corners");
    Vec3d position;
    RETURN_IF_ERROR(parse_position(next_position_words(scanner_), scanner_,
                                   {"facet", mesh_.triangles.size()}, nullptr, position,
                                   mesh_.has_double_positions));
    triangle_[corners_++] = welder_.index_of(position);
    return Status::ok();
  }

  Status end_facet() {
    if (corners_ != 3)
      return scanner_.error(facet_text() + " has " + std::to_string(corners_) +
                            " corners; a facet needs 3");
    mesh_.triangles.push_back(triangle_);
    corners_ = 0;
    return Status::ok();
  }

  std::string facet_text() const { return "facet " + std::to_string(mesh_.triangles.size()); }

  TextScanner scanner_;
  Mesh& mesh_;
  VertexWelder<decltype(Mesh::vertices)> welder_;
  bool in_solid_ = false;
  Triangle triangle_ = {};
  size_t corners_ = 0;
};

template <typename Mesh>
static Status read_either(std::span<const uint8_t> bytes, const std::string& name,
                          const FileSteps& steps, Mesh& mesh) {
  if (!is_stl_text(bytes)) return read_binary(bytes, name, steps, mesh);
  RETURN_IF_ERROR(check_line_lengths(bytes, name, steps));
  return AsciiStlReader(bytes, name, steps, mesh).read();
}

Result<TriangleMesh> read_stl(std::span<const uint8_t> bytes, const std::string& name,
                              const FileSteps& steps) {
  TriangleMesh mesh;
  RETURN_IF_ERROR(read_either(bytes, name, steps, mesh));
  return mesh;
}

Status read_stl(std::span<const uint8_t> bytes, const std::string& name, const FileSteps& steps,
                GrowingMesh& mesh) {
  return read_either(bytes, name, steps, mesh);
}

}  // namespace burnish
