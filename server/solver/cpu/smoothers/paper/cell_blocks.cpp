#include <algorithm>
#include <array>

#include "server/solver/cpu/smoothers/cell_inverse.h"
#include "server/solver/cpu/smoothers/smoother.h"
#include "server/solver/hierarchy/cell_matrix.h"

namespace burnish::cpu {

namespace {

constexpr int kColours = 8;
constexpr int kBrickShift = 6;  // Morton bits: the rows of a brick of 4×4×4 cells stay in cache

/// Cells that one thread relaxes in order: [first, last).
struct Brick {
  int32_t first;
  int32_t last;
};

class CellBlocks final : public DepthSmoother {
 public:
  // Two bricks of one colour are at least a brick apart. (Colours of single cells would need 27
  // colours: a cell's residual reaches one cell further than its corners.)
  explicit CellBlocks(const HierarchyDepth& topology) : inverses_(topology.grid.cells.size()) {
    const auto& cells = topology.grid.cells;
    for (int32_t first = 0, last = 0; first < topology.grid.cell_count(); first = last) {
      const MortonKey brick = cells[first].place >> kBrickShift;
      while (last < topology.grid.cell_count() && cells[last].place >> kBrickShift == brick) ++last;
      bricks_[brick & 7].push_back({first, last});
    }
  }

  void set_up(CpuDepth& depth) override {
    const Scratch<CellInverse> inverses = invert_cells(depth);
#pragma omp parallel for schedule(static)
    for (size_t cell = 0; cell < inverses_.size(); ++cell) inverses_[cell] = inverses[cell];
  }

  void relax_from_zero(CpuDepth& depth) override {
    std::fill(depth.x.begin(), depth.x.end(), Float4::Zero());
    for (int colour = 0; colour < kColours; ++colour)
      relax_colour(colour, [&](const Brick& brick) {
        for (int32_t cell = brick.first; cell < brick.last; ++cell) relax_cell(depth, cell);
      });
  }

  void relax(CpuDepth& depth) override {
    for (int colour = kColours - 1; colour >= 0; --colour)
      relax_colour(colour, [&](const Brick& brick) {
        for (int32_t cell = brick.last - 1; cell >= brick.first; --cell) relax_cell(depth, cell);
      });
  }

  uint64_t byte_count() const override {
    uint64_t bytes = bytes_of(inverses_);
    for (const auto& of_colour : bricks_) bytes += bytes_of(of_colour);
    return bytes;
  }

 private:
  template <typename RelaxBrick>
  void relax_colour(int colour, RelaxBrick&& relax_brick) const {
    const auto& bricks = bricks_[colour];
#pragma omp parallel for schedule(static)
    for (size_t i = 0; i < bricks.size(); ++i) relax_brick(bricks[i]);
  }

  // Does x += R_cᵀ (B_c + reg)⁻¹ R_c (f − S x).
  void relax_cell(CpuDepth& depth, int32_t cell) const {
    const auto& corners = depth.topology.grid.cell_corners[cell];
    const CellInverse& inverse = inverses_[cell];
    std::array<Float4, kCornersPerCell> residual, correction;
    for (int a = 0; a < kCornersPerCell; ++a) {
      residual[a] = depth.f[corners[a]] -
                    product_row(depth.topology.stencil, depth.system, depth.x, corners[a]);
      correction[a] = inverse.diagonal[a] * residual[a];
    }
    for (int a = 0, p = 0; a < kCornersPerCell; ++a)
      for (int b = a + 1; b < kCornersPerCell; ++b, ++p) {
        correction[a] += inverse.pair[p] * residual[b];
        correction[b] += inverse.pair[p] * residual[a];
      }
    for (int a = 0; a < kCornersPerCell; ++a) depth.x[corners[a]] += correction[a];
  }

  std::array<std::vector<Brick>, kColours> bricks_;
  std::vector<CellInverse> inverses_;
};

}  // namespace

std::unique_ptr<DepthSmoother> make_cell_blocks(const HierarchyDepth& topology) {
  return std::make_unique<CellBlocks>(topology);
}

}  // namespace burnish::cpu
