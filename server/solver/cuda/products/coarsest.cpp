#include "server/solver/cuda/products/coarsest.h"

#include "server/solver/cuda/mesh/long_rows.h"
#include "server/solver/cuda/mesh/row_groups.h"

namespace burnish::cuda {

CoarsestSolver::CoarsestSolver(Stream& stream, const HierarchyDepth& topology, const Depth& depth)
    : stream_(stream), depth_(depth) {
  if (topology.grid.corner_count() <= DenseInverse::kCornersMax)
    dense_ = DenseInverse(stream, depth);
  else
    host_.emplace(topology);
}

void CoarsestSolver::factor() {
  if (on_device()) return dense_.factor(stream_);
  read_matrix();
  if (stream_.is_ok()) host_solver_.factor(*host_);
}

// Copies the device's slices into the host's rows.
void CoarsestSolver::read_matrix() {
  const Stencil& stencil = host_->topology.stencil;
  const std::vector<int64_t> starts = slice_starts(stencil);
  std::vector<uint32_t> packed(starts.back());
  std::vector<float> rest(starts.back());
  download(stream_, depth_.system.packed, std::span(packed));
  download(stream_, depth_.system.rest, std::span(rest));
  std::vector<float> tails(depth_.topology.rows.long_rows.entry_count);
  download(stream_, depth_.system.long_entries, std::span(tails));
  download(stream_, depth_.system.diagonal, std::span(host_->system.diagonal));
  download(stream_, depth_.inverse_diagonal, std::span(host_->inverse_diagonal));
  auto tail = tails.begin();
  for (int32_t i = 0; i < host_->corner_count(); ++i) {
    int64_t from = starts[i / kSliceRows] + i % kSliceRows;
    auto [k, end] = packed_part(stencil, i);
    for (; k < end; ++k, from += kSliceRows)
      host_->system.entry[k] = value_of(packed[from]) + rest[from];
    for (; k < stencil.row(i).end; ++k) host_->system.entry[k] = *tail++;
  }
}

void CoarsestSolver::solve() {
  if (on_device()) return dense_.solve(stream_);
  static_assert(sizeof(cpu::Float4) == sizeof(float4));
  const auto as_float4 = [](std::vector<cpu::Float4>& v) {
    return std::span(reinterpret_cast<float4*>(v.data()), v.size());
  };
  download(stream_, depth_.f, as_float4(host_->f));
  if (stream_.is_ok()) host_solver_.solve(*host_);
  upload(stream_, depth_.x, std::span<const float4>(as_float4(host_->x)));
}

}  // namespace burnish::cuda
