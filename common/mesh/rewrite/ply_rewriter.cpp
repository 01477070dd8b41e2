#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string_view>
#include <vector>

#include "common/mesh/ply_ascii_source.h"
#include "common/mesh/ply_binary_source.h"
#include "common/mesh/ply_colour.h"
#include "common/mesh/ply_layout.h"
#include "common/mesh/rewrite/byte_patch.h"
#include "common/mesh/rewrite/format_rewriters.h"
#include "common/mesh/rewrite/moved_normals.h"
#include "common/mesh/rewrite/ply_number.h"

namespace burnish {

namespace {

/// Where a vertex's properties x, y, z or nx, ny, nz are among its properties.
using Properties = std::array<size_t, 3>;

std::optional<Properties> find_properties(const PlyElement& vertex,
                                          const std::array<const char*, 3>& names) {
  Properties places;
  for (size_t axis = 0; axis < 3; ++axis) {
    const PlyProperty* property = vertex.find(names[axis]);
    if (property == nullptr || property->is_list()) return std::nullopt;
    places[axis] = static_cast<size_t>(property - vertex.properties.data());
  }
  return places;
}

/// Replaces numbers in the element vertex; `Source` reads the body.
template <typename Source>
class PlyBodyRewriter {
 public:
  PlyBodyRewriter(Source source, const PlyHeader& header, const std::string& name,
                  const PlyLayout& layout, const MovedMesh& moved, BytePatch& patch)
      : source_(std::move(source)),
        header_(header),
        vertex_(*header.find("vertex")),
        name_(name),
        slots_(layout.vertex_slots),
        has_colours_(layout.has_colours && moved.after.has_colours()),
        moved_(moved),
        patch_(patch) {}

  Status rewrite() {
    positions_ = find_properties(vertex_, {"x", "y", "z"}).value();
    normals_ = find_properties(vertex_, {"nx", "ny", "nz"});
    if (normals_) areas_ = gather_vertex_areas(moved_);
    values_.resize(vertex_.properties.size());
    for (const PlyElement& element : header_.elements) {
      for (uint64_t i = 0; i < element.count && !element.properties.empty(); ++i) {
        RETURN_IF_ERROR(read(element, i));
        if (&element == &vertex_) RETURN_IF_ERROR(rewrite_vertex(i));
      }
      if (&element == &vertex_) break;
    }
    return Status::ok();
  }

 private:
  /// A number of the current vertex: where it is, what it is, what it becomes.
  struct Value {
    std::string_view bytes;
    double before = 0;
    double after = 0;
  };

  Status read(const PlyElement& element, uint64_t number) {
    for (size_t p = 0; p < element.properties.size(); ++p) {
      const PlyProperty& property = element.properties[p];
      double value = 0;
      const bool is_read =
          property.is_list() ? skip_list(property) : source_.read(property.type, value);
      if (!is_read)
        return changed_original(
            name_, element.name + " " + std::to_string(number) + ": " + source_.failure());
      if (&element == &vertex_ && !property.is_list())
        values_[p] = {source_.last_bytes(), value, value};
    }
    if (source_.at_line_end()) return Status::ok();
    return changed_original(name_, element.name + " " + std::to_string(number) + " is longer");
  }

  bool skip_list(const PlyProperty& property) {
    double count;
    return source_.read(*property.count_type, count) && count >= 0 &&
           source_.skip(property.type, static_cast<uint64_t>(count));
  }

  Status rewrite_vertex(uint64_t v) {
    for (size_t axis = 0; axis < 3; ++axis) {
      Value& value = values_[positions_[axis]];
      const auto axis_number = static_cast<int>(axis);
      RETURN_IF_ERROR(check_unchanged(moved_, name_, v, axis_number, value.before));
      value.after = moved_.after.vertices[v][axis_number];
    }
    if (normals_) turn_normal(v);
    if (has_colours_) recolour(v);
    for (size_t p = 0; p < values_.size(); ++p) put(p);
    return Status::ok();
  }

  /// A channel that reads as the same byte keeps its number, which may be finer.
  void recolour(uint64_t v) {
    for (size_t p = 0; p < values_.size(); ++p) {
      if (slots_[p] < kPlyRed || slots_[p] >= kPlyIgnored) continue;
      const uint8_t byte = moved_.after.colours[v][slots_[p] - kPlyRed];
      const PlyType type = vertex_.properties[p].type;
      if (colour_byte(values_[p].before, type) != byte) values_[p].after = channel_of(byte, type);
    }
  }

  void turn_normal(uint64_t v) {
    Vec3d normal;
    for (size_t axis = 0; axis < 3; ++axis)
      normal[static_cast<int>(axis)] = values_[(*normals_)[axis]].before;
    normal = areas_[v].turn(normal);
    for (size_t axis = 0; axis < 3; ++axis)
      values_[(*normals_)[axis]].after = normal[static_cast<int>(axis)];
  }

  void put(size_t p) {
    const Value& value = values_[p];
    const PlyProperty& property = vertex_.properties[p];
    if (property.is_list() || std::isnan(value.before) || value.after == value.before) return;
    const PlyType type = written_type(p);
    const double kept = kept_by(type, value.after);
    if (kept == kept_by(type, value.before)) return;
    patch_.replace(value.bytes, ply_number(type, header_.encoding, kept));
  }

  /// A text may have more digits than its type says, or fewer.
  PlyType written_type(size_t p) const {
    const PlyType type = vertex_.properties[p].type;
    const bool is_position = std::find(positions_.begin(), positions_.end(), p) != positions_.end();
    if (!is_position || is_integer(type) || header_.encoding != PlyEncoding::kAscii) return type;
    return moved_.after.has_double_positions ? PlyType::kFloat64 : PlyType::kFloat32;
  }

  Source source_;
  const PlyHeader& header_;
  const PlyElement& vertex_;
  const std::string& name_;
  const std::vector<size_t>& slots_;
  const bool has_colours_;
  const MovedMesh& moved_;
  BytePatch& patch_;
  Properties positions_ = {};
  std::optional<Properties> normals_;
  std::vector<AreaVectors> areas_;  // one per vertex if there are normals
  std::vector<Value> values_;       // one per property of the current vertex
};

template <typename Source>
Status rewrite_body(std::span<const uint8_t> bytes, const PlyHeader& header,
                    const std::string& name, const PlyLayout& layout, const MovedMesh& moved,
                    BytePatch& patch) {
  return PlyBodyRewriter<Source>(Source(bytes, header, name), header, name, layout, moved, patch)
      .rewrite();
}

}  // namespace

Status rewrite_ply(std::span<const uint8_t> bytes, const std::string& name, const MovedMesh& moved,
                   OutputBuffer& output) {
  ASSIGN_OR_RETURN(const PlyHeader header, parse_ply_header(bytes, name));
  ASSIGN_OR_RETURN(const PlyLayout layout, find_ply_layout(header, name));
  if (layout.vertices != moved.before.size())
    return changed_original(name, "it has " + std::to_string(layout.vertices) +
                                      " vertices, it had " + std::to_string(moved.before.size()));
  const auto rewrite = header.encoding == PlyEncoding::kAscii ? rewrite_body<PlyAsciiSource>
                       : header.encoding == PlyEncoding::kLittleEndian
                           ? rewrite_body<PlyBinarySource<false>>
                           : rewrite_body<PlyBinarySource<true>>;
  BytePatch patch(bytes, output);
  RETURN_IF_ERROR(rewrite(bytes, header, name, layout, moved, patch));
  patch.finish();
  return Status::ok();
}

}  // namespace burnish
