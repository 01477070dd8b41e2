#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string_view>
#include <vector>

#include "common/mesh/ply/ply_ascii_source.h"
#include "common/mesh/ply/ply_binary_source.h"
#include "common/mesh/ply/ply_colour.h"
#include "common/mesh/ply/ply_layout.h"
#include "common/mesh/reading/text_values.h"
#include "common/mesh/rewrite/format_rewriters.h"
#include "common/mesh/rewrite/moved/moved_normals.h"
#include "common/mesh/rewrite/moved/placed_normals.h"
#include "common/mesh/rewrite/patch/byte_patch.h"
#include "common/mesh/rewrite/patch/ply_number.h"
#include "common/mesh/rewrite/patch/written_mesh.h"
#include "common/mesh/rewrite/ply_walk.h"

namespace burnish {

namespace {

/// Indices of x, y, z or nx, ny, nz among an element's properties.
using Properties = std::array<size_t, 3>;

std::optional<Properties> find_properties(const PlyElement& element,
                                          const std::array<const char*, 3>& names) {
  Properties places;
  for (size_t axis = 0; axis < 3; ++axis) {
    const PlyProperty* property = element.find(names[axis]);
    if (property == nullptr || property->is_list()) return std::nullopt;
    places[axis] = static_cast<size_t>(property - element.properties.data());
  }
  return places;
}

Vec3d vector_at(std::span<const PlyValue> values, const Properties& places) {
  return {values[places[0]].number, values[places[1]].number, values[places[2]].number};
}

/// Replaces numbers of the elements vertex and face; `Source` reads the body.
template <typename Source>
class PlyBodyRewriter {
 public:
  PlyBodyRewriter(const Source& source, const PlyHeader& header, const std::string& name,
                  const PlyLayout& layout, const MovedMesh& moved, BytePatch& patch)
      : source_(source),
        header_(header),
        vertex_(*header.find("vertex")),
        face_(header.find("face")),
        name_(name),
        layout_(layout),
        has_colours_(layout.has_colours && moved.after.has_colours()),
        moved_(moved),
        patch_(patch) {
    positions_ = find_properties(vertex_, {"x", "y", "z"}).value();
    normals_ = find_properties(vertex_, {"nx", "ny", "nz"});
    if (face_ != nullptr && layout.face_list != kPlyNoList)
      face_normals_ = find_properties(*face_, {"nx", "ny", "nz"});
  }

  Status rewrite() {
    RETURN_IF_ERROR(look_ahead());
    const WrittenNumber text = WrittenNumber::of_text(moved_, digits_);
    const std::array<WrittenNumber, 3> axes = {axis(0, text), axis(1, text), axis(2, text)};
    written_.emplace(moved_, axes);
    normal_number_ = WrittenNumber::of_normals(normal_digits_);
    if (normals_) gather_areas();
    PlyWalk<Source> walk(source_, name_);
    size_t left = face_normals_ ? 2 : 1;  // elements to change
    for (const PlyElement& element : header_.elements) {
      const bool is_vertex = &element == &vertex_, is_face = face_normals_ && &element == face_;
      if (is_vertex && has_float_colours(vertex_, layout_))
        largest_float_ = largest_float_channel(walk.source(), vertex_, layout_);
      for (uint64_t i = 0; i < element.count && !element.properties.empty(); ++i) {
        RETURN_IF_ERROR(walk.read(element, i, is_face ? layout_.face_list : kPlyNoList));
        if (is_vertex) RETURN_IF_ERROR(rewrite_vertex(walk.values(), i));
        if (is_face) RETURN_IF_ERROR(rewrite_face(walk, i));
      }
      left -= is_vertex || is_face;
      if (left == 0) break;
    }
    return Status::ok();
  }

 private:
  bool is_text() const { return header_.encoding == PlyEncoding::kAscii; }

  /// Reads what must be known of all vertices and faces before the first is written.
  Status look_ahead() {
    if (normals_) vertex_places_ = find_places(moved_.before);
    const bool needs_normals = vertex_places_.are_shared();
    if (!needs_normals && !is_text()) return Status::ok();
    PlyWalk<Source> walk(source_, name_);
    size_t left = is_text() && face_normals_ ? 2 : 1;  // elements to look at
    for (const PlyElement& element : header_.elements) {
      const bool is_vertex = &element == &vertex_, is_face = face_normals_ && &element == face_;
      for (uint64_t i = 0; i < element.count && !element.properties.empty(); ++i) {
        RETURN_IF_ERROR(walk.read(element, i));
        if (is_vertex && needs_normals)
          old_normals_.emplace_back(vector_at(walk.values(), *normals_).template cast<float>());
        if (is_vertex) add_digits(element, positions_, walk.values(), digits_);
        if (is_vertex && normals_) add_digits(element, *normals_, walk.values(), normal_digits_);
        if (is_face) add_digits(element, *face_normals_, walk.values(), normal_digits_);
      }
      left -= is_vertex || (left == 2 && is_face);
      if (left == 0) break;
    }
    return Status::ok();
  }

  /// Does nothing in a binary.
  void add_digits(const PlyElement& element, const Properties& places,
                  std::span<const PlyValue> values, TextDigits& digits) const {
    if (!is_text()) return;
    for (const size_t p : places)
      if (!is_integer(element.properties[p].type)) digits.add(values[p].bytes);
  }

  /// A text may have more digits than its type says, or fewer.
  WrittenNumber axis(size_t number, const WrittenNumber& text) const {
    const PlyType type = vertex_.properties[positions_[number]].type;
    if (is_text() && !is_integer(type)) return text;
    return {.type = type, .is_text = is_text(), .digits = {}};
  }

  void gather_areas() {
    areas_ = gather_vertex_areas(written_->moved());
    if (!old_normals_.empty()) share_areas(vertex_places_.of_vertex, old_normals_, areas_);
    vertex_places_ = {};
    old_normals_ = {};
  }

  Status rewrite_vertex(std::span<const PlyValue> values, uint64_t v) {
    after_.resize(values.size());
    for (size_t p = 0; p < values.size(); ++p) after_[p] = values[p].number;
    for (size_t axis = 0; axis < 3; ++axis) {
      const double before = values[positions_[axis]].number;
      const auto axis_number = static_cast<int>(axis);
      RETURN_IF_ERROR(check_unchanged(moved_, name_, v, axis_number, before));
      if (is_coordinate(before))
        after_[positions_[axis]] = written_->moved().after.vertices[v][axis_number];
    }
    if (normals_) turn(*normals_, values, areas_[v]);
    if (has_colours_) recolour(values, v);
    for (size_t p = 0; p < values.size(); ++p) put(vertex_, p, values[p]);
    return Status::ok();
  }

  /// Takes a face's triangles by its corners, as the reader does.
  Status rewrite_face(const PlyWalk<Source>& walk, uint64_t number) {
    corners_.clear();
    for (const double index : walk.list()) {
      if (!(index >= 0 && index < static_cast<double>(moved_.before.size())))
        return changed_original(name_, "face " + std::to_string(number) + " has other corners");
      corners_.push_back(static_cast<uint32_t>(index));
    }
    AreaVectors area;
    for (size_t i = 2; i < corners_.size(); ++i)
      area.add(written_->moved(), {corners_[0], corners_[i - 1], corners_[i]});
    const std::span<const PlyValue> values = walk.values();
    after_.resize(values.size());
    turn(*face_normals_, values, area);
    for (const size_t p : *face_normals_) put(*face_, p, values[p]);
    return Status::ok();
  }

  void turn(const Properties& places, std::span<const PlyValue> values, const AreaVectors& area) {
    const Vec3d normal = area.turn(vector_at(values, places));
    for (size_t axis = 0; axis < 3; ++axis) after_[places[axis]] = normal[static_cast<int>(axis)];
  }

  /// A channel that reads as the same byte keeps its number, which may be finer.
  void recolour(std::span<const PlyValue> values, uint64_t v) {
    for (size_t p = 0; p < values.size(); ++p) {
      const size_t slot = layout_.vertex_slots[p];
      if (slot < kPlyRed || slot >= kPlyIgnored) continue;
      const uint8_t byte = moved_.after.colours[v][slot - kPlyRed];
      const double full = full_channel(vertex_.properties[p].type, largest_float_);
      if (colour_byte(values[p].number, full) != byte) after_[p] = channel_of(byte, full);
    }
  }

  void put(const PlyElement& element, size_t p, const PlyValue& value) {
    const PlyProperty& property = element.properties[p];
    if (property.is_list() || std::isnan(value.number) || after_[p] == value.number) return;
    for (size_t axis = 0; &element == &vertex_ && axis < 3; ++axis)
      if (p == positions_[axis]) return put_position(axis, value);
    if (is_text() && is_normal(element, p) && !is_integer(property.type))
      return put_normal(after_[p], value);
    const double kept = kept_by(property.type, after_[p]);
    if (kept == kept_by(property.type, value.number)) return;
    patch_.replace(value.bytes, ply_number(property.type, header_.encoding, kept));
  }

  void put_position(size_t axis, const PlyValue& value) {
    const double after = after_[positions_[axis]];
    const WrittenNumber& number = written_->axis(axis);
    patch_.replace(value.bytes, is_text() ? number.text_of(after, value.number, value.bytes)
                                          : ply_number(number.type, header_.encoding, after));
  }

  bool is_normal(const PlyElement& element, size_t p) const {
    const auto& places = &element == &vertex_ ? normals_ : face_normals_;
    return places && std::find(places->begin(), places->end(), p) != places->end();
  }

  void put_normal(double after, const PlyValue& value) {
    if (!normal_number_.tells_apart(after, value.number)) return;
    const double kept = normal_number_.kept(after, value.number);
    patch_.replace(value.bytes, normal_number_.text_of(kept, value.number, value.bytes));
  }

  const Source source_;  // at the beginning of the body
  const PlyHeader& header_;
  const PlyElement& vertex_;
  const PlyElement* const face_;
  const std::string& name_;
  const PlyLayout& layout_;
  const bool has_colours_;
  const MovedMesh& moved_;
  BytePatch& patch_;
  Properties positions_ = {};
  std::optional<Properties> normals_;
  std::optional<Properties> face_normals_;
  TextDigits digits_, normal_digits_;  // of a text
  WrittenNumber normal_number_;
  Places vertex_places_;            // if there are normals
  std::vector<Vec3f> old_normals_;  // if vertices share places
  std::optional<WrittenMesh> written_;
  std::vector<AreaVectors> areas_;  // one per vertex if there are normals
  double largest_float_ = 0;        // among colours
  std::vector<double> after_;       // one per property of the current element
  std::vector<uint32_t> corners_;   // of the current face
};

template <typename Source>
Status rewrite_body(std::span<const uint8_t> bytes, const PlyHeader& header,
                    const std::string& name, const PlyLayout& layout, const MovedMesh& moved,
                    const FileSteps& steps, BytePatch& patch) {
  return PlyBodyRewriter<Source>(Source(bytes, header, name, steps), header, name, layout, moved,
                                 patch)
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
  RETURN_IF_ERROR(rewrite(bytes, header, name, layout, moved, FileSteps(output.budget()), patch));
  patch.finish();
  return Status::ok();
}

}  // namespace burnish
