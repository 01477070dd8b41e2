#include "common/mesh/ply/ply_texture_reader.h"

#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "common/mesh/ply/ply_ascii_source.h"
#include "common/mesh/ply/ply_binary_source.h"
#include "common/mesh/ply/ply_header.h"
#include "common/mesh/ply/ply_layout.h"
#include "common/mesh/ply/ply_textures.h"

namespace burnish {

namespace {

constexpr size_t kNoProperty = kPlyNoList;

/// Which properties of a PLY file make its textures.
struct PlyTextureLayout {
  size_t u = kNoProperty;            ///< of element vertex
  size_t v = kNoProperty;            ///< of element vertex
  size_t corners = kNoProperty;      ///< of element face: the list of its vertices
  size_t coordinates = kNoProperty;  ///< of element face: a list of u and v by corner
  size_t picture = kNoProperty;      ///< of element face
  bool has_strips_first = false;

  bool is_on_vertices() const { return coordinates == kNoProperty && u != kNoProperty; }
  bool is_on_faces() const { return coordinates != kNoProperty || picture != kNoProperty; }
};

size_t property_number(const PlyElement* element, std::string_view name, bool is_list) {
  if (element == nullptr) return kNoProperty;
  const auto found = std::ranges::find_if(element->properties, [&](const PlyProperty& property) {
    return property.name == name && property.is_list() == is_list;
  });
  return found == element->properties.end()
             ? kNoProperty
             : static_cast<size_t>(found - element->properties.begin());
}

PlyTextureLayout find_texture_layout(const PlyHeader& header) {
  PlyTextureLayout layout;
  using Pair = std::pair<const char*, const char*>;
  for (const auto& [u, v] : {Pair("texture_u", "texture_v"), Pair("u", "v"), Pair("s", "t")}) {
    const std::pair numbers(property_number(header.find("vertex"), u, false),
                            property_number(header.find("vertex"), v, false));
    if (numbers.first != kNoProperty && numbers.second != kNoProperty)
      std::tie(layout.u, layout.v) = numbers;
  }
  const PlyElement *face = header.find("face"), *strips = header.find("tristrips");
  layout.coordinates = property_number(face, "texcoord", true);
  layout.picture = property_number(face, "texnumber", false);
  layout.has_strips_first = face != nullptr && strips != nullptr && strips < face;
  if (const auto mesh = find_ply_layout(header, ""); mesh.is_ok()) layout.corners = mesh->face_list;
  return layout;
}

/// Walks through a PLY file's body and keeps what each triangle shows.
template <typename Source>
class PlyTextureReader {
 public:
  PlyTextureReader(Source source, const PlyHeader& header, const PlyTextureLayout& layout,
                   SurfaceTextures& textures)
      : source_(std::move(source)), header_(header), layout_(layout), textures_(textures) {}

  /// Gives `triangles` the coordinates of vertices, then those of faces. Stops where the file does.
  void read(std::span<const Triangle> triangles) {
    for (const PlyElement& element : header_.elements)
      if (!element.properties.empty() && !read_element(element)) break;
    textures_.triangles.assign(triangles.size(), {.material = 0});
    if (layout_.is_on_vertices())
      for (size_t t = 0; t < triangles.size(); ++t) textures_.triangles[t].corners = triangles[t];
    if (faces_.size() > triangles.size()) return;
    const size_t first = layout_.has_strips_first ? triangles.size() - faces_.size() : 0;
    std::ranges::copy(faces_, textures_.triangles.begin() + static_cast<ptrdiff_t>(first));
  }

 private:
  bool read_element(const PlyElement& element) {
    const bool is_vertex = element.name == "vertex" && layout_.is_on_vertices();
    const bool is_face = element.name == "face" && layout_.is_on_faces();
    values_.resize(element.properties.size());
    for (uint64_t e = 0; e < element.count; ++e) {
      for (size_t p = 0; p < element.properties.size(); ++p)
        if (!read_property(element.properties[p], values_[p])) return false;
      if (!source_.at_line_end()) return false;
      if (is_vertex) add_coordinate(values_[layout_.u][0], values_[layout_.v][0]);
      if (is_face) add_face();
    }
    return true;
  }

  bool read_property(const PlyProperty& property, std::vector<double>& values) {
    double count = 1;
    if (property.is_list() && !source_.read(*property.count_type, count)) return false;
    if (!(count >= 0) || count > static_cast<double>(source_.values_left_max(property.type)))
      return false;
    values.resize(static_cast<size_t>(count));
    return std::ranges::all_of(values,
                               [&](double& value) { return source_.read(property.type, value); });
  }

  void add_coordinate(double u, double v) {
    textures_.coordinates.push_back({static_cast<float>(u), static_cast<float>(v)});
  }

  uint32_t material_of_face() const {
    const double number = layout_.picture == kNoProperty ? 0 : values_[layout_.picture][0];
    const bool is_there = number >= 0 && number < static_cast<double>(textures_.materials.size());
    return is_there ? static_cast<uint32_t>(number) : kNoTexture;
  }

  /// Returns the coordinate of a corner of the face, which add_coordinates() has added from `first`
  /// on.
  uint32_t corner_of_face(size_t corner, uint32_t first) const {
    if (layout_.coordinates != kNoProperty)
      return first == kNoTexture ? kNoTexture : first + static_cast<uint32_t>(corner);
    return layout_.is_on_vertices() ? static_cast<uint32_t>(values_[layout_.corners][corner])
                                    : kNoTexture;
  }

  /// Returns where the face's coordinates begin, or kNoTexture if it has too few.
  uint32_t add_coordinates(size_t corners) {
    if (layout_.coordinates == kNoProperty) return kNoTexture;
    const std::vector<double>& list = values_[layout_.coordinates];
    const size_t first = textures_.coordinates.size();
    if (list.size() < 2 * corners || first + corners >= kNoTexture) return kNoTexture;
    for (size_t i = 0; i < corners; ++i) add_coordinate(list[2 * i], list[2 * i + 1]);
    return static_cast<uint32_t>(first);
  }

  /// Makes the triangles of append_fan().
  void add_face() {
    if (layout_.corners == kNoProperty) return;
    const size_t corners = values_[layout_.corners].size();
    const uint32_t material = material_of_face();
    const uint32_t first = add_coordinates(corners);
    for (size_t i = 2; i < corners; ++i)
      faces_.push_back(
          {material,
           {corner_of_face(0, first), corner_of_face(i - 1, first), corner_of_face(i, first)}});
  }

  Source source_;
  const PlyHeader& header_;
  const PlyTextureLayout& layout_;
  SurfaceTextures& textures_;
  std::vector<std::vector<double>> values_;  // of an element, by property
  std::vector<TexturedTriangle> faces_;
};

void add_pictures(const std::vector<std::string>& names, const MeshSurroundings& beside,
                  SurfaceTextures& textures) {
  std::map<std::string, uint32_t> pictures;  // by path: many names may be one
  for (const std::string& name : names) {
    SurfaceMaterial& material = textures.materials.emplace_back();
    material.to_picture.linear().diagonal() << 1, -1;
    material.to_picture.translation() << 0, 1;
    const auto path = beside.files->find(folder_of(beside.path), name);
    if (!path) continue;
    const auto [found, is_new] =
        pictures.emplace(*path, static_cast<uint32_t>(textures.pictures.size()));
    material.picture = found->second;
    if (is_new)
      textures.pictures.push_back(
          {*path, [files = beside.files, path = *path] { return files->read(path); }, *path});
  }
}

template <typename Source>
void read_texture_body(std::span<const uint8_t> ply, const PlyHeader& header,
                       const PlyTextureLayout& layout, std::span<const Triangle> triangles,
                       const FileBudget& budget, SurfaceTextures& textures) {
  const std::string name;
  const Source source(ply, header, name, FileSteps(budget));
  PlyTextureReader<Source>(source, header, layout, textures).read(triangles);
}

}  // namespace

SurfaceTextures read_ply_textures(std::span<const uint8_t> ply, std::span<const Triangle> triangles,
                                  const MeshSurroundings& beside) {
  SurfaceTextures textures;
  add_pictures(textures_in_ply(ply), beside, textures);
  const auto header = parse_ply_header(ply, "");
  if (textures.pictures.empty() || !header.is_ok()) return {};
  const PlyTextureLayout layout = find_texture_layout(*header);
  if (!layout.is_on_vertices() && !layout.is_on_faces()) return textures;
  switch (header->encoding) {
    case PlyEncoding::kAscii:
      read_texture_body<PlyAsciiSource>(ply, *header, layout, triangles, beside.budget, textures);
      break;
    case PlyEncoding::kLittleEndian:
      read_texture_body<PlyBinarySource<false>>(ply, *header, layout, triangles, beside.budget,
                                                textures);
      break;
    case PlyEncoding::kBigEndian:
      read_texture_body<PlyBinarySource<true>>(ply, *header, layout, triangles, beside.budget,
                                               textures);
      break;
  }
  return textures;
}

}  // namespace burnish
