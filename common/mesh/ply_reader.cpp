#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "common/mesh/mesh_formats.h"
#include "common/mesh/ply_ascii_source.h"
#include "common/mesh/ply_binary_source.h"
#include "common/mesh/ply_header.h"
#include "common/mesh/polygon.h"
#include "common/mesh/text_values.h"

namespace burnish {

namespace {

/// What becomes of a vertex's properties, by position in `kVertexProperties`.
constexpr std::array<std::string_view, 7> kVertexProperties = {"x",     "y",    "z",    "red",
                                                               "green", "blue", "alpha"};
constexpr size_t kRed = 3;
constexpr size_t kAlpha = 6;
constexpr size_t kIgnored = 7;

/// A value past the edge of its strip: the next index begins another.
constexpr double kRestart = -1;
constexpr double kRestartUnsigned = 0xFFFFFFFF;

bool is_index_list(const PlyProperty& property) {
  return property.name == "vertex_indices" || property.name == "vertex_index";
}

uint8_t colour_byte(double value, PlyType type) {
  double scaled = value;
  if (!is_integer(type)) scaled = 255 * value;
  if (type == PlyType::kUint16) scaled = value / 257;
  return static_cast<uint8_t>(std::lround(scaled >= 0 ? std::min(scaled, 255.0) : 0));
}

/// Checks once what the loops over the body then rely on.
Status check_elements(const PlyHeader& header, const std::string& name) {
  const PlyElement* vertex = header.find("vertex");
  if (vertex == nullptr) return invalid_argument(name + ": the header has no element 'vertex'");
  for (size_t axis = 0; axis < 3; ++axis) {
    const PlyProperty* property = vertex->find(kVertexProperties[axis]);
    if (property == nullptr || property->is_list())
      return invalid_argument(name + ": element 'vertex' has no property " +
                              in_quotes(kVertexProperties[axis]) + " that is a number");
  }
  bool has_faces = false;
  for (const char* element_name : {"face", "tristrips"}) {
    const PlyElement* element = header.find(element_name);
    if (element == nullptr || element->count == 0) continue;
    has_faces = true;
    const auto& properties = element->properties;
    const auto list = std::find_if(properties.begin(), properties.end(), is_index_list);
    if (list == properties.end() || !list->is_list() || !is_integer(list->type))
      return invalid_argument(name + ": element " + in_quotes(element_name) +
                              " has no list 'vertex_indices' of integers");
  }
  if (has_faces) return Status::ok();
  return invalid_argument(name + ": the file has no faces, only points");
}

template <typename Source>
class PlyBodyReader {
 public:
  PlyBodyReader(Source source, const PlyHeader& header)
      : source_(std::move(source)), header_(header), vertices_(header.find("vertex")->count) {}

  Result<TriangleMesh> read() {
    for (const PlyElement& element : header_.elements) {
      if (element.properties.empty()) continue;
      if (element.name == "vertex") {
        RETURN_IF_ERROR(read_vertices(element));
      } else {
        RETURN_IF_ERROR(read_lists(element));
      }
    }
    return std::move(mesh_);
  }

 private:
  Status read_vertices(const PlyElement& element) {
    std::vector<size_t> slots;
    for (const PlyProperty& property : element.properties) slots.push_back(slot_of(property));
    const bool has_colours = std::count_if(slots.begin(), slots.end(), is_rgb) == 3;
    mesh_.vertices.resize(vertices_);
    if (has_colours) mesh_.colours.resize(vertices_, {0, 0, 0, 255});
    for (uint64_t v = 0; v < vertices_; ++v) {
      for (size_t p = 0; p < slots.size(); ++p) {
        const PlyProperty& property = element.properties[p];
        double value;
        if (property.is_list()) {
          RETURN_IF_ERROR(skip_list(element, v, property));
        } else if (!source_.read(property.type, value)) {
          return read_error(element, v);
        } else if (slots[p] < kRed) {
          if (!is_coordinate(value)) return coordinate_error(v, slots[p], value);
          if (!mesh_.has_double_positions)
            mesh_.has_double_positions = source_.last_exceeds_float(value);
          mesh_.vertices[v][static_cast<Eigen::Index>(slots[p])] = value;
        } else if (slots[p] < kIgnored && has_colours) {
          mesh_.colours[v][slots[p] - kRed] = colour_byte(value, property.type);
        }
      }
      if (!source_.at_line_end()) return leftover_error(element, v);
    }
    return Status::ok();
  }

  /// Also notes coordinates of a type that says more than a float.
  size_t slot_of(const PlyProperty& property) {
    if (property.is_list()) return kIgnored;
    const auto known = std::find(kVertexProperties.begin(), kVertexProperties.end(), property.name);
    const auto slot = static_cast<size_t>(known - kVertexProperties.begin());
    if (slot < kRed && (property.type == PlyType::kFloat64 || property.type == PlyType::kInt32 ||
                        property.type == PlyType::kUint32))
      mesh_.has_double_positions = true;
    return slot;
  }

  static bool is_rgb(size_t slot) { return slot >= kRed && slot < kAlpha; }

  /// Faces and strips; other elements are only skipped.
  Status read_lists(const PlyElement& element) {
    const bool is_face = element.name == "face";
    const bool is_strip = element.name == "tristrips";
    const PlyProperty* indices = nullptr;
    for (const PlyProperty& property : element.properties)
      if (indices == nullptr && (is_face || is_strip) && is_index_list(property))
        indices = &property;
    if (is_face) mesh_.triangles.reserve(mesh_.triangles.size() + element.count);
    for (uint64_t e = 0; e < element.count; ++e) {
      for (const PlyProperty& property : element.properties) {
        if (&property == indices) {
          RETURN_IF_ERROR(is_face ? read_face(element, e, property)
                                  : read_strip(element, e, property));
        } else if (property.is_list()) {
          RETURN_IF_ERROR(skip_list(element, e, property));
        } else if (!source_.skip(property.type, 1)) {
          return read_error(element, e);
        }
      }
      if (!source_.at_line_end()) return leftover_error(element, e);
    }
    return Status::ok();
  }

  Status read_face(const PlyElement& element, uint64_t f, const PlyProperty& list) {
    uint64_t corners;
    RETURN_IF_ERROR(read_count(element, f, list, corners));
    if (corners < 3) return source_.error(corner_count_complaint(f, static_cast<int64_t>(corners)));
    corners_.resize(corners);
    for (uint32_t& corner : corners_) {
      double index;
      if (!source_.read(list.type, index)) return read_error(element, f);
      if (!is_vertex(index)) return index_error(element, f, index);
      corner = static_cast<uint32_t>(index);
    }
    append_fan(corners_, mesh_.triangles);
    return Status::ok();
  }

  /// Each index makes a triangle with the two before it, every other one turned round. Triangles
  /// that repeat an index are joints of the strip, not faces of the surface.
  Status read_strip(const PlyElement& element, uint64_t s, const PlyProperty& list) {
    uint64_t count;
    RETURN_IF_ERROR(read_count(element, s, list, count));
    uint64_t length = 0;
    uint32_t a = 0;
    uint32_t b = 0;
    for (uint64_t i = 0; i < count; ++i) {
      double index;
      if (!source_.read(list.type, index)) return read_error(element, s);
      if (index == kRestart || index == kRestartUnsigned) {
        length = 0;
        continue;
      }
      if (!is_vertex(index)) return index_error(element, s, index);
      const auto c = static_cast<uint32_t>(index);
      ++length;
      if (length >= 3 && a != b && b != c && c != a)
        mesh_.triangles.push_back(length % 2 == 1 ? Triangle{a, b, c} : Triangle{b, a, c});
      a = b;
      b = c;
    }
    return Status::ok();
  }

  Status skip_list(const PlyElement& element, uint64_t number, const PlyProperty& list) {
    uint64_t count;
    RETURN_IF_ERROR(read_count(element, number, list, count));
    if (!source_.skip(list.type, count)) return read_error(element, number);
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
    return index >= 0 && index < static_cast<double>(vertices_);
  }

  /// Of a count or an index, both within what 64 bits hold.
  static std::string integer_text(double value) {
    return std::to_string(static_cast<int64_t>(value));
  }

  Status error(const PlyElement& element, uint64_t number, const std::string& what) const {
    return source_.error(element.name + " " + std::to_string(number) + ": " + what);
  }
  Status read_error(const PlyElement& element, uint64_t number) const {
    return error(element, number, source_.failure());
  }
  Status leftover_error(const PlyElement& element, uint64_t number) const {
    return error(element, number, "the line goes on after its last value");
  }
  Status index_error(const PlyElement& element, uint64_t number, double index) const {
    return error(element, number,
                 "refers to vertex " + integer_text(index) + ", but there are " +
                     std::to_string(vertices_) + ", numbered from 0");
  }
  Status coordinate_error(uint64_t vertex, size_t axis, double value) const {
    return source_.error(
        coordinate_complaint({"vertex", vertex}, static_cast<int>(axis), number_text(value)));
  }

  Source source_;
  const PlyHeader& header_;
  const uint64_t vertices_;
  TriangleMesh mesh_;
  std::vector<uint32_t> corners_;
};

template <typename Source>
Result<TriangleMesh> read_body(std::span<const uint8_t> bytes, const PlyHeader& header,
                               const std::string& name) {
  return PlyBodyReader<Source>(Source(bytes, header, name), header).read();
}

}  // namespace

Result<TriangleMesh> read_ply(std::span<const uint8_t> bytes, const std::string& name) {
  ASSIGN_OR_RETURN(const PlyHeader header, parse_ply_header(bytes, name));
  RETURN_IF_ERROR(check_elements(header, name));
  switch (header.encoding) {
    case PlyEncoding::kAscii:
      return read_body<PlyAsciiSource>(bytes, header, name);
    case PlyEncoding::kLittleEndian:
      return read_body<PlyBinarySource<false>>(bytes, header, name);
    case PlyEncoding::kBigEndian:
      return read_body<PlyBinarySource<true>>(bytes, header, name);
  }
  return invalid_argument(name + ": unknown PLY encoding");
}

}  // namespace burnish
