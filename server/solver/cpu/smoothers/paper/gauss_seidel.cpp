#include <array>

#include "server/solver/cpu/smoothers/smoother.h"

namespace burnish::cpu {

namespace {

constexpr int kColours = 8;
constexpr int kSweeps = 2;

class GaussSeidel final : public DepthSmoother {
 public:
  // The lowest Morton bits are the parities of i, j, k: corners of one colour share no cell.
  explicit GaussSeidel(const HierarchyDepth& topology) {
    for (int32_t corner = 0; corner < topology.grid.corner_count(); ++corner)
      corners_[topology.grid.corners[corner].place & 7].push_back(corner);
  }

  void set_up(CpuDepth&) override {}

  void relax_from_zero(CpuDepth& depth) override {
    std::fill(depth.x.begin(), depth.x.end(), Float4::Zero());
    for (int sweep = 0; sweep < kSweeps; ++sweep)
      for (int colour = 0; colour < kColours; ++colour) relax_colour(depth, colour);
  }

  void relax(CpuDepth& depth) override {
    for (int sweep = 0; sweep < kSweeps; ++sweep)
      for (int colour = kColours - 1; colour >= 0; --colour) relax_colour(depth, colour);
  }

  uint64_t byte_count() const override {
    uint64_t bytes = 0;
    for (const auto& of_colour : corners_) bytes += bytes_of(of_colour);
    return bytes;
  }

 private:
  void relax_colour(CpuDepth& depth, int colour) const {
    const auto& corners = corners_[colour];
#pragma omp parallel for schedule(static)
    for (size_t i = 0; i < corners.size(); ++i) {
      const int32_t corner = corners[i];
      depth.x[corner] +=
          depth.inverse_diagonal[corner] *
          (depth.f[corner] - product_row(depth.topology.stencil, depth.system, depth.x, corner));
    }
  }

  std::array<std::vector<int32_t>, kColours> corners_;
};

}  // namespace

std::unique_ptr<DepthSmoother> make_gauss_seidel(const HierarchyDepth& topology) {
  return std::make_unique<GaussSeidel>(topology);
}

}  // namespace burnish::cpu
