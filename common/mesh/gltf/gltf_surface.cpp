#include "common/mesh/gltf/gltf_surface.h"

#include <algorithm>
#include <cmath>

#include "common/mesh/gltf/gltf_textures.h"
#include "common/mesh/reading/vertex_welder.h"
#include "common/mesh/srgb.h"
#include "common/mesh/textures/texture_colours.h"

namespace burnish {

namespace {

class GltfSurfaceReader {
 public:
  explicit GltfSurfaceReader(UnpackedViews& views) : views_(views), welder_(mesh_.vertices) {}

  Result<GltfSurface> read() {
    ASSIGN_OR_RETURN(surface_.placements, place_meshes(views_.document()));
    for (size_t p = 0; p < surface_.placements.size(); ++p) RETURN_IF_ERROR(read_placement(p));
    if (has_colours_) mesh_.colours.resize(mesh_.vertices.size(), kWhite);
    surface_.mesh = std::move(mesh_);
    return std::move(surface_);
  }

 private:
  static constexpr uint32_t kWantedVertex = kNoVertex - 1;
  static constexpr Rgba8 kWhite = {255, 255, 255, 255};

  Status read_placement(size_t placement) {
    const uint64_t mesh = surface_.placements[placement].mesh;
    const GltfJson* primitives =
        find_member(views_.document().json.at("meshes")[mesh], "primitives");
    const size_t count = primitives != nullptr && primitives->is_array() ? primitives->size() : 0;
    for (size_t i = 0; i < count; ++i) {
      RETURN_IF_ERROR(views_.charge(1));  // many nodes may place a mesh of many empty primitives
      ASSIGN_OR_RETURN(const GltfPrimitive* primitive, find_primitive(mesh, i));
      if (primitive != nullptr) RETURN_IF_ERROR(add_part(placement, *primitive));
    }
    return Status::ok();
  }

  Result<const GltfPrimitive*> find_primitive(uint64_t mesh, uint64_t number) {
    const auto [found, is_new] = surface_.primitives.try_emplace({mesh, number});
    if (is_new) {
      ASSIGN_OR_RETURN(found->second, read_primitive(views_, mesh, number));
    }
    return found->second ? &*found->second : nullptr;
  }

  /// Returns the points of a primitive's positions under a node. Primitives may share them.
  Result<size_t> find_points(size_t placement, const GltfPrimitive& primitive) {
    const GltfAccessor& positions = primitive.positions();
    const uint64_t own = primitive.is_draco ? primitive.number : kNoAccessor;
    const auto [found, is_new] =
        points_.try_emplace({placement, positions.index, own}, surface_.points.size());
    if (is_new) {
      RETURN_IF_ERROR(views_.charge(sizeof(uint32_t) * positions.count));
      surface_.points.push_back({placement, positions, {}});
      surface_.points.back().vertices.assign(positions.count, kNoVertex);
    }
    return found->second;
  }

  Status add_part(size_t placement, const GltfPrimitive& primitive) {
    constexpr uint64_t kVertexBytes = 44;  // with its place in the welder
    const uint64_t corners = primitive.corner_count();
    const uint64_t triangles = primitive.mode == GltfMode::kTriangles ? corners / 3 : corners;
    RETURN_IF_ERROR(views_.charge(triangles * sizeof(Triangle) +
                                  std::min(corners, primitive.positions().count) * kVertexBytes));
    ASSIGN_OR_RETURN(const size_t points, find_points(placement, primitive));
    RETURN_IF_ERROR(weld_vertices(surface_.points[points], primitive));
    const std::vector<uint32_t>& vertices = surface_.points[points].vertices;
    const bool is_mirrored = surface_.placements[placement].to_scene.linear().determinant() < 0;
    const size_t first = mesh_.triangles.size();
    for_each_triangle(primitive, [&](uint32_t a, uint32_t b, uint32_t c) {
      views_.steps().take();
      if (is_mirrored) std::swap(b, c);
      mesh_.triangles.push_back({vertices[a], vertices[b], vertices[c]});
    });
    surface_.parts.push_back(
        {placement, &primitive, points, first, mesh_.triangles.size() - first});
    return Status::ok();
  }

  /// Gives the positions that a primitive's triangles use their vertices, in the order of the file.
  Status weld_vertices(GltfPoints& points, const GltfPrimitive& primitive) {
    constexpr uint64_t kPositionsPerByte = 4;  // of the charge for looking at positions
    uint32_t least = UINT32_MAX, largest = 0;
    for_each_triangle(primitive, [&](uint32_t a, uint32_t b, uint32_t c) {
      views_.steps().take();
      for (const uint32_t i : {a, b, c}) {
        least = std::min(least, i);
        largest = std::max(largest, i);
        if (points.vertices[i] == kNoVertex) points.vertices[i] = kWantedVertex;
      }
    });
    if (least > largest) return Status::ok();
    RETURN_IF_ERROR(views_.charge((largest - least) / kPositionsPerByte));
    for (uint64_t i = least; i <= largest; ++i) {
      views_.steps().take();
      if (points.vertices[i] == kWantedVertex) RETURN_IF_ERROR(weld(points, primitive, i));
    }
    return Status::ok();
  }

  Status weld(GltfPoints& points, const GltfPrimitive& primitive, uint64_t i) {
    const GltfPlacement& placed = surface_.placements[points.placement];
    const GltfAccessor& p = points.positions;
    Vec3d position(p.number(i, 0), p.number(i, 1), p.number(i, 2));
    if (!placed.is_identity) position = placed.to_scene * position;
    if (!position.allFinite())  // the welder never finds NaN again
      return invalid_argument(primitive_text(primitive.mesh, primitive.number) + ": position " +
                              std::to_string(i) + " is not finite");
    const uint32_t vertex = points.vertices[i] = welder_.index_of(position);
    mesh_.has_double_positions |= position.cast<float>().cast<double>() != position;
    if (const GltfAccessor* colours = primitive.find("COLOR_0")) set_colour(*colours, i, vertex);
    return Status::ok();
  }

  /// The first colour of a place stays.
  void set_colour(const GltfAccessor& colours, uint64_t i, uint32_t vertex) {
    has_colours_ = true;
    if (vertex < mesh_.colours.size()) return;
    mesh_.colours.resize(vertex, kWhite);
    Rgba8 colour = kWhite;
    for (uint32_t c = 0; c < 3; ++c) colour[c] = srgb_byte(colours.number(i, c));
    if (colours.element.components == 4) colour[3] = unit_byte(colours.number(i, 3));
    mesh_.colours.push_back(colour);
  }

  UnpackedViews& views_;
  TriangleMesh mesh_;
  VertexWelder<std::vector<Vec3d>> welder_;
  GltfSurface surface_;
  std::map<std::tuple<size_t, uint64_t, uint64_t>, size_t> points_;
  bool has_colours_ = false;
};

}  // namespace

Result<GltfSurface> read_gltf_surface(UnpackedViews& views) {
  return GltfSurfaceReader(views).read();
}

Result<TriangleMesh> read_gltf(std::span<const uint8_t> bytes, const std::string& name,
                               const GltfFilesBeside& buffers, const MeshSurroundings& beside) {
  const FileSteps steps(beside.budget);
  auto document = open_gltf(bytes, buffers, steps);
  if (!document.is_ok()) return document.status().with_context(name);
  UnpackedViews views(*document, steps);
  auto surface = read_gltf_surface(views);
  if (!surface.is_ok()) return surface.status().with_context(name);
  RETURN_IF_ERROR(add_texture_colours(surface->mesh, read_gltf_textures(views, *surface, beside),
                                      beside.budget, name));
  return std::move(surface->mesh);
}

}  // namespace burnish
