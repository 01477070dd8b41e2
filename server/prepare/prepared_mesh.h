#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "common/base/progress.h"
#include "common/base/scratch_space.h"
#include "common/base/status.h"
#include "common/base/types.h"
#include "common/evaluation/evaluation.h"
#include "common/grid/cell_corners.h"
#include "common/grid/grid.h"
#include "common/mesh/statistics/statistics.h"
#include "common/mesh/statistics/thin_walls.h"

namespace burnish {

/// Metric-independent integrals of one cell over the surface inside it (section 4.3), grid units.
/// Pairs (a, b), a < b, of local corners are ordered (0,1), (0,2), ..., (0,7), (1,2), ...: see
/// pair_index(). Diagonals are not stored: they follow from the row sums (of ℓ: zero), which keeps
/// constants exact. In double: on flat pieces whole combinations of corners have no energy, and
/// float32 tables would make it negative. The gradients ∫ ⟨v_i, ∇B_a⟩ v_i need no table: they are
/// stiffness times the corners' places (gradient_of() in solver/hierarchy/cell_matrix.h).
struct CellIntegrals {
  std::array<double, kPairsPerCell> mass;                      ///< ρ_ab
  std::array<double, 8> mass_row_sum;                          ///< Σ_b ρ_ab = ∫ B_a
  std::array<std::array<double, kPairsPerCell>, 2> stiffness;  ///< ℓ¹_ab, ℓ²_ab
};
static_assert(sizeof(CellIntegrals) == 736);

/// Area-weighted means over a cell, user units (κ·L), and the clipped area in grid units.
struct CellCurvature {
  float kappa1;  ///< the algebraically larger principal curvature
  float kappa2;
  float area;
};

/// The part of a cell's surface that belongs to one component of the mesh.
struct CellSheet {
  int32_t cell;
  uint32_t component;  ///< its least vertex
  uint32_t passages;   ///< like PreparedMesh::passages, of this component alone
};

inline constexpr int kSheetsPerCellMax = 8;

/// The area of the surface by curvature, for the transfer-curve editor. Bins are even in
/// asinh(κ) between -range and range; both κ1 and κ2 count.
struct CurvatureHistogram {
  static constexpr int kBins = 128;
  float range = 1;                     ///< user units; the last bins hold all beyond
  std::array<float, kBins> area = {};  ///< fraction of the total
};

/// Seconds by phase and peak bytes of one preparation.
struct PrepareReport {
  struct Phase {
    std::string name;
    double seconds = 0;
    uint64_t peak_bytes = 0;  ///< resident memory of the process at its end
  };
  std::vector<Phase> phases;
};

/// The data of a scan at one depth that no edit changes. Immutable; sessions share it. The spans
/// point into storage that the object owns: vectors, or a file's content.
class PreparedMesh {
 public:
  GridFrame frame;
  double length_unit = 1;       ///< L = sqrt(total area), file units
  double curvature_radius = 0;  ///< averaging radius as a fraction of L
  MeshStatistics statistics;
  bool has_double_positions = false;
  CurvatureHistogram histogram;
  ThinWalls walls;

  std::span<const Vec3d> vertices;
  std::span<const Triangle> triangles;
  std::span<const Rgba8> colours;               ///< empty or one per vertex
  std::span<const EvaluationPoint> evaluation;  ///< one per vertex
  std::span<const MortonKey> cells;             ///< the finest depth, strictly rising
  std::span<const CellIntegrals> integrals;     ///< one per cell
  std::span<const CellCurvature> curvature;     ///< one per cell
  /// One per cell. Bit s: the surface leads on into the cell at stencil slot s
  /// (common/grid/stencil_slots.h). Either a triangle lies in both cells, or a triangle on each
  /// side meets the grid plane between them with an edge or its whole area. Two cells may share
  /// corners without a passage. Bit 26 - s of the other cell is the same passage.
  std::span<const uint32_t> passages;
  /// The sheets of the cells through which several components of the mesh pass, by cell, then by
  /// component. A soup has none.
  std::span<const CellSheet> sheets;
  std::span<const CellIntegrals> sheet_integrals;  ///< one per sheet

  /// α in grid units is α in user units times this.
  double alpha_scale() const { return frame.cell_size / length_unit; }
  uint64_t byte_count() const;  ///< of all the spans
  /// Returns the bytes of memory that the spans hold for good.
  uint64_t memory_byte_count() const { return is_in_file ? 0 : byte_count(); }

  bool is_in_file = false;  ///< the spans lie in a mapped file: the kernel can drop them
  std::shared_ptr<const void> storage;  ///< owns the memory behind the spans
};

/// Writes the prepared mesh to `path` through a synced temporary file. Fails: cancelled; as errno
/// says.
Status write_prepared_mesh(const PreparedMesh& prepared, const std::filesystem::path& path,
                           const Progress& progress = {});

/// Reads a copy of a prepared file into scratch space: a mapping of the file itself would end the
/// process when somebody shortens it. Fails: not_found; data_loss that names the section when the
/// version, a size or a checksum is wrong; resource_exhausted if the space has no room.
Result<std::shared_ptr<const PreparedMesh>> read_prepared_mesh(const std::filesystem::path& path,
                                                               const ScratchSpace& space = {});

/// Maps a prepared file where it lies, under a lease (LeasedFile). `folder` takes its copy, should
/// somebody write to it. Fails: failed_precondition, if there is no lease; as read_prepared_mesh().
Result<std::shared_ptr<const PreparedMesh>> hold_prepared_mesh(const std::filesystem::path& path,
                                                               const std::filesystem::path& folder);

/// The facts in the header of a prepared file.
struct PreparedSummary {
  double length_unit = 1;
  double cell_size = 1;
  CurvatureHistogram histogram;
  ThinWalls walls;
  uint64_t vertices = 0;
  uint64_t cells = 0;
  uint64_t byte_count = 0;  ///< of the mesh in memory
};

/// Reads only the header. Fails: as read_prepared_mesh(), except for the sections.
Result<PreparedSummary> read_prepared_summary(const std::filesystem::path& path);

/// Raise this when the format changes, or when numbers change by more than rounding.
inline constexpr uint32_t kPreparedFormatVersion = 6;

}  // namespace burnish
