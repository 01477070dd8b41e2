#include "client/gl/surface_buffers.h"

#include "client/gl/gl_error.h"
#include "common/base/check.h"

namespace burnish {

SurfaceBuffers::SurfaceBuffers()
    : cell_corners_(GL_RGBA32I, 16),
      displacements_(GL_RGBA32F, 16),
      cell_values_(GL_R32F, 4),
      cell_tint_(GL_R32F, 4) {}

Status SurfaceBuffers::upload(const ViewMesh& mesh) {
  const size_t cells = mesh.cell_corners.size();
  const std::string of_cells = "the grid of " + std::to_string(cells) + " cells";
  RETURN_IF_ERROR(cell_corners_.allocate(2 * cells, of_cells));
  RETURN_IF_ERROR(displacements_.allocate(mesh.corner_count, of_cells));
  RETURN_IF_ERROR(cell_values_.allocate(cells, of_cells));
  RETURN_IF_ERROR(cell_tint_.allocate(cells, of_cells));
  cell_corners_.write(0, std::as_bytes(std::span(mesh.cell_corners)));
  return check_gl(of_cells);
}

Status SurfaceBuffers::upload_displacements(std::span<const Vec3f> displacements,
                                            std::span<const IndexRange> changed) {
  BURNISH_CHECK(displacements.size() == displacements_.size(), "one displacement per corner");
  for (const IndexRange& range : changed) {
    padded_.clear();
    for (const Vec3f& u : displacements.subspan(range.first, range.count))
      padded_.emplace_back(u.x(), u.y(), u.z(), 0.0f);
    displacements_.write(range.first, std::as_bytes(std::span(padded_)));
  }
  return check_gl("displacements");
}

Status SurfaceBuffers::upload_cell_values(std::span<const float> values) {
  BURNISH_CHECK(values.size() == cell_values_.size(), "one value per cell");
  cell_values_.write(0, std::as_bytes(values));
  return check_gl("values of cells");
}

Status SurfaceBuffers::upload_cell_tint(std::span<const float> weights, IndexRange changed) {
  BURNISH_CHECK(weights.size() == cell_tint_.size(), "one tint per cell");
  cell_tint_.write(changed.first, std::as_bytes(weights.subspan(changed.first, changed.count)));
  return check_gl("tint of cells");
}

void SurfaceBuffers::bind() const {
  cell_corners_.bind(kCellCornersUnit);
  displacements_.bind(kDisplacementsUnit);
  cell_values_.bind(kCellValuesUnit);
  cell_tint_.bind(kCellTintUnit);
}

}  // namespace burnish
