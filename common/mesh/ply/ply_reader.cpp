#include <algorithm>
#include <cmath>
#include <vector>

#include "common/mesh/ply/ply.h"
#include "common/mesh/ply/ply_ascii_source.h"
#include "common/mesh/ply/ply_binary_source.h"
#include "common/mesh/ply/ply_colour.h"
#include "common/mesh/ply/ply_header.h"
#include "common/mesh/ply/ply_layout.h"
#include "common/mesh/reading/odd_vertices.h"
#include "common/mesh/reading/polygon.h"
#include "common/mesh/reading/text_values.h"

namespace burnish {

namespace {

/// Indices that end a strip and begin the next: -1, also in the form of unsigned types.
constexpr double kRestart = -1;
constexpr double kRestartUnsigned = 0xFFFFFFFF;

/// Fills a TriangleMesh or a GrowingMesh.
template <typename Source, typename Mesh>
class PlyBodyReader {
 public:
  PlyBodyReader(Source source, uint64_t file_bytes, const PlyHeader& header,
                const PlyLayout& layout, Mesh& mesh)
      : source_(std::move(source)),
        file_bytes_(file_bytes),
        header_(header),
        layout_(layout),
        mesh_(mesh) {
    mesh_.has_double_positions = layout.has_double_positions;
  }

  Status read() {
    for (const PlyElement& element : header_.elements) {
      if (element.properties.empty()) continue;
      RETURN_IF_ERROR(element.name == "vertex" ? read_vertices(element) : read_lists(element));
    }
    return odd_.settle({mesh_.vertices.data(), mesh_.vertices.size()},
                       {mesh_.triangles.data(), mesh_.triangles.size()});
  }

 private:
  Status read_vertices(const PlyElement& element) {
    mesh_.vertices.resize(layout_.vertices, Vec3d::Zero());
    if (layout_.has_colours) mesh_.colours.resize(layout_.vertices, Rgba8{0, 0, 0, 255});
    if (has_float_colours(element, layout_))
      largest_float_channel_ = largest_float_channel(source_, element, layout_);
    for (uint64_t v = 0; v < layout_.vertices; ++v) {
      for (size_t p = 0; p < element.properties.size(); ++p)
        RETURN_IF_ERROR(read_vertex_property(element, v, p));
      if (!source_.at_line_end()) return leftover_error(element, v);
    }
    return Status::ok();
  }

  Status read_vertex_property(const PlyElement& element, uint64_t v, size_t p) {
    const PlyProperty& property = element.properties[p];
    const size_t slot = layout_.vertex_slots[p];
    if (slot == kPlyIgnored) return skip(element, v, property);
    double value;
    if (!source_.read(property.type, value)) return read_error(element, v);
    if (slot >= kPlyRed) {
      if (layout_.has_colours)
        mesh_.colours[v][slot - kPlyRed] =
            colour_byte(value, full_channel(property.type, largest_float_channel_));
      return Status::ok();
    }
    const auto axis = static_cast<int>(slot);
    mesh_.vertices[v][axis] = value;
    if (!is_coordinate(value))
      odd_.keep(v, source_.error(coordinate_complaint({"vertex", v}, axis, number_text(value))));
    else if (!mesh_.has_double_positions)
      mesh_.has_double_positions = source_.last_exceeds_float(value);
    return Status::ok();
  }

  /// Reads faces and strips; skips other elements.
  Status read_lists(const PlyElement& element) {
    const bool is_face = element.name == "face";
    const bool is_strip = element.name == "tristrips";
    const size_t list = is_face ? layout_.face_list : is_strip ? layout_.strip_list : kPlyNoList;
    if (is_face) mesh_.triangles.reserve(mesh_.triangles.size() + element.count);
    for (uint64_t e = 0; e < element.count; ++e) {
      for (size_t p = 0; p < element.properties.size(); ++p) {
        const PlyProperty& property = element.properties[p];
        if (p != list) {
          RETURN_IF_ERROR(skip(element, e, property));
        } else {
          RETURN_IF_ERROR(is_face ? read_face(element, e, property)
                                  : read_strip(element, e, property));
        }
      }
      if (!source_.at_line_end()) return leftover_error(element, e);
    }
    return Status::ok();
  }

  Status read_face(const PlyElement& element, uint64_t f, const PlyProperty& list) {
    uint64_t count;
    RETURN_IF_ERROR(read_count(element, f, list, count));
    corners_.resize(count);
    for (uint32_t& corner : corners_) {
      double index;
      if (!source_.read(list.type, index)) return read_error(element, f);
      if (!is_vertex(index)) return index_error(element, f, index);
      corner = static_cast<uint32_t>(index);
    }
    append_fan(corners_, mesh_.triangles);
    return check_unfolding();
  }

  Status read_strip(const PlyElement& element, uint64_t s, const PlyProperty& list) {
    uint64_t count;
    RETURN_IF_ERROR(read_count(element, s, list, count));
    TriangleStrip strip;
    for (uint64_t i = 0; i < count; ++i) {
      double index;
      if (!source_.read(list.type, index)) return read_error(element, s);
      if (index == kRestart || index == kRestartUnsigned) {
        strip = TriangleStrip();
        continue;
      }
      if (!is_vertex(index)) return index_error(element, s, index);
      strip.append(static_cast<uint32_t>(index), mesh_.triangles);
      RETURN_IF_ERROR(check_unfolding());
    }
    return Status::ok();
  }

  Status check_unfolding() const {
    if (!unfolds_too_far(mesh_.triangles, file_bytes_)) return Status::ok();
    return source_.error(unfolding_complaint(mesh_.triangles, file_bytes_));
  }

  Status skip(const PlyElement& element, uint64_t number, const PlyProperty& property) {
    uint64_t count = 1;
    if (property.is_list()) RETURN_IF_ERROR(read_count(element, number, property, count));
    if (!source_.skip(property.type, count)) return read_error(element, number);
    return Status::ok();
  }

  Status read_count(const PlyElement& element, uint64_t number, const PlyProperty& list,
                    uint64_t& count) {
    double value;
    if (!source_.read(*list.count_type, value)) return read_error(element, number);
    const uint64_t limit = source_.values_left_max(list.type);
    if (value < 0 || value > static_cast<double>(limit))
      return error(element, number,
                   "list " + in_quotes(list.name) + " has the count " + integer_text(value) +
                       ", but at most " + std::to_string(limit) + " values are left in the file");
    count = static_cast<uint64_t>(value);
    return Status::ok();
  }

  bool is_vertex(double index) const {
    return index >= 0 && index < static_cast<double>(layout_.vertices);
  }

  Status error(const PlyElement& element, uint64_t number, const std::string& what) const {
    return source_.error(element.name + " " + std::to_string(number) + ": " + what);
  }
  Status read_error(const PlyElement& element, uint64_t number) const {
    return error(element, number, source_.failure());
  }
  Status leftover_error(const PlyElement& element, uint64_t number) const {
    return error(element, number, "the line continues after its last value");
  }
  Status index_error(const PlyElement& element, uint64_t number, double index) const {
    return source_.error(
        index_complaint(element.name, number, integer_text(index), layout_.vertices));
  }

  Source source_;
  const uint64_t file_bytes_;
  const PlyHeader& header_;
  const PlyLayout& layout_;
  Mesh& mesh_;
  OddVertices odd_;
  double largest_float_channel_ = 0;
  std::vector<uint32_t> corners_;
};

template <typename Source, typename Mesh>
Status read_body(std::span<const uint8_t> bytes, const PlyHeader& header, const PlyLayout& layout,
                 const std::string& name, const FileSteps& steps, Mesh& mesh) {
  return PlyBodyReader<Source, Mesh>(Source(bytes, header, name, steps), bytes.size(), header,
                                     layout, mesh)
      .read();
}

template <typename Mesh>
Status read_into(std::span<const uint8_t> bytes, const std::string& name, const FileSteps& steps,
                 Mesh& mesh) {
  ASSIGN_OR_RETURN(const PlyHeader header, parse_ply_header(bytes, name));
  ASSIGN_OR_RETURN(const PlyLayout layout, find_ply_layout(header, name));
  switch (header.encoding) {
    case PlyEncoding::kAscii:
      return read_body<PlyAsciiSource>(bytes, header, layout, name, steps, mesh);
    case PlyEncoding::kLittleEndian:
      return read_body<PlyBinarySource<false>>(bytes, header, layout, name, steps, mesh);
    case PlyEncoding::kBigEndian:
      return read_body<PlyBinarySource<true>>(bytes, header, layout, name, steps, mesh);
  }
  return invalid_argument(name + ": unknown PLY encoding");
}

}  // namespace

Result<TriangleMesh> read_ply(std::span<const uint8_t> bytes, const std::string& name,
                              const FileSteps& steps) {
  TriangleMesh mesh;
  RETURN_IF_ERROR(read_into(bytes, name, steps, mesh));
  return mesh;
}

Status read_ply(std::span<const uint8_t> bytes, const std::string& name, const FileSteps& steps,
                GrowingMesh& mesh) {
  return read_into(bytes, name, steps, mesh);
}

}  // namespace burnish
