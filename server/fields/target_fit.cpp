#include "server/fields/target_fit.h"

#include <algorithm>
#include <atomic>
#include <limits>

#include "common/base/heard_loop.h"
#include "server/prepare/admission.h"
#include "server/prepare/cell_pieces.h"

namespace burnish {
namespace {

using Mat3d = Eigen::Matrix3d;

// Keeps the inverse where a cell's pieces lie in one plane: along its normal no gradient is known.
constexpr double kUnknownShare = 1e-3;  // of the area

// A cell's mean normal has a length: 0 for two sides of a wall, 0.26 for an edge of 30 degrees.
constexpr double kMeanNormalMin = 0.25;

/// A triangle's tangent projection, which is its ∇x, and the gradients that are wanted of it.
struct TriangleGradients {
  Vec3d normal = Vec3d::Zero();  ///< the wanted one
  Mat3d own = Mat3d::Zero();
  Mat3d left = Mat3d::Zero();     ///< D
  Mat3d changed = Mat3d::Zero();  ///< c∇w + D
};

TriangleGradients gradients_of(const PreparedMesh& prepared, const SurfaceTarget& target,
                               uint32_t triangle) {
  const Triangle& corners = prepared.triangles[triangle];
  const auto place = [&](int i) { return prepared.vertices[corners[i % 3]]; };
  const Vec3d across = (place(1) - place(0)).cross(place(2) - place(0));
  const double twice_area = across.norm();
  if (!(twice_area > 0)) return {};
  const Vec3d normal = across / twice_area;
  TriangleGradients gradients;
  gradients.own = Mat3d::Identity() - normal * normal.transpose();
  Mat3d layer = Mat3d::Zero();
  for (int i = 0; i < 3; ++i) {
    const Vec3d slope = normal.cross(place(i + 2) - place(i + 1)) / twice_area;
    layer += target.layer[corners[i]].cast<double>() * slope.transpose();
  }
  layer *= target.crispness;
  const Vec3d wanted = target.normals[triangle].cast<double>();
  gradients.normal = wanted;
  gradients.left = -wanted * (wanted.transpose() * (gradients.own + layer));
  gradients.changed = layer + gradients.left;
  return gradients;
}

double area_in_cell(const GridMesh& mesh, const CellPiece& piece) {
  const Polygon polygon = clip_to_cell(mesh.corners(piece.triangle), morton_point(piece.cell));
  Vec3d twice = Vec3d::Zero();
  for (int i = 2; i < polygon.count; ++i)
    twice += (polygon.vertices[i - 1] - polygon.vertices[0])
                 .cross(polygon.vertices[i] - polygon.vertices[0]);
  return twice.norm() / 2;
}

/// The sums of the least squares over a cell's pieces.
class CellFit {
 public:
  void add(const TriangleGradients& of, double area) {
    area_ += area;
    normal_ += area * of.normal;
    own_ += area * of.own;
    left_ += area * of.left;
    changed_ += area * of.changed;
  }

  TargetGradient matrices() const {
    if (!(area_ > std::numeric_limits<double>::min())) return {};
    if (normal_.norm() < kMeanNormalMin * area_) return {};
    const Mat3d inverse = (own_ / area_ + kUnknownShare * Mat3d::Identity()).inverse() / area_;
    return {rows_of(changed_ * inverse), rows_of(left_ * inverse)};
  }

 private:
  static std::array<float, 9> rows_of(const Mat3d& matrix) {
    std::array<float, 9> rows;
    Eigen::Map<Eigen::Matrix<float, 3, 3, Eigen::RowMajor>>(rows.data()) = matrix.cast<float>();
    return rows;
  }

  double area_ = 0;
  Vec3d normal_ = Vec3d::Zero();
  Mat3d own_ = Mat3d::Zero(), left_ = Mat3d::Zero(), changed_ = Mat3d::Zero();
};

using Matrices = std::vector<TargetGradient>;

// Fills the matrices of the cells that have pieces; both lie in the order of cells.
void fit_cells(const PreparedMesh& prepared, const SurfaceTarget& target, const GridMesh& mesh,
               std::span<const CellPiece> pieces, const Progress& progress, Matrices& cells) {
  const std::vector<size_t> chunks = chunks_of_cells(pieces);
  LoopProgress loop(progress, "fit", 0, 1);
  std::atomic<size_t> done{0};
  ask_before(loop);
#pragma omp parallel for schedule(dynamic)
  for (size_t chunk = 0; chunk < chunks.size() - 1; ++chunk) {
    const auto all = static_cast<double>(chunks.size() - 1);
    if (!loop.goes_on(static_cast<double>(done++) / all)) continue;
    for (size_t begin = chunks[chunk]; begin < chunks[chunk + 1];) {
      const size_t end = end_of_cell(pieces, begin);
      CellFit fit;
      for (const CellPiece& piece : pieces.subspan(begin, end - begin))
        if (!target.normals[piece.triangle].isZero())
          fit.add(gradients_of(prepared, target, piece.triangle), area_in_cell(mesh, piece));
      const auto cell = std::ranges::lower_bound(prepared.cells, pieces[begin].cell);
      if (cell != prepared.cells.end() && *cell == pieces[begin].cell)
        cells[cell - prepared.cells.begin()] = fit.matrices();
      begin = end;
    }
  }
  leave_if_cancelled(loop);
}

// Reports the phases of a part of the work as that part of one phase.
Progress part_of(const Progress& progress, double begin, double end) {
  if (!progress) return {};
  return [&progress, begin, end](std::string_view, double done) {
    return progress("gradients", begin + (end - begin) * done);
  };
}

Result<Matrices> fit(const PreparedMesh& prepared, const SurfaceTarget& target,
                     const Progress& progress) {
  MeshView view;
  view.vertices = prepared.vertices;
  view.triangles = prepared.triangles;
  const ScratchSpace space;
  const ScratchArray<Vec3d> positions = snapped_positions(view, prepared.frame, space, {});
  const GridMesh mesh = {prepared.triangles, positions, prepared.frame.depth};
  constexpr uint64_t kAnyNumber = std::numeric_limits<uint64_t>::max();
  constexpr double kCounted = 0.3, kFound = 0.7;  // of the time
  ASSIGN_OR_RETURN(const PieceCount count,
                   count_cell_pieces(mesh, kAnyNumber, part_of(progress, 0, kCounted)));
  ASSIGN_OR_RETURN(const ScratchArray<CellPiece> pieces,
                   find_cell_pieces(mesh, count, {space}, part_of(progress, kCounted, kFound)));
  Matrices cells(prepared.cells.size());
  fit_cells(prepared, target, mesh, pieces, part_of(progress, kFound, 1), cells);
  return cells;
}

}  // namespace

Result<Matrices> fit_target(const PreparedMesh& prepared, const SurfaceTarget& target,
                            const Progress& progress) {
  try {
    return fit(prepared, target, progress);
  } catch (const WorkCancelled&) {
    return cancelled("cancelled while fitting the wanted gradients");
  }
}

}  // namespace burnish
