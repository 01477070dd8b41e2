#include "server/solver/cuda/gradient_scale.h"

#include <algorithm>

#include "server/solver/cuda/uniform.h"

namespace burnish::cuda {

GradientScale::GradientScale(Stream& stream, size_t cells)
    : many_(stream, cells), now_(stream, cells), change_(stream, cells) {
  view_ = {true, true, 0, 0, 0, 0, many_.data(), now_.data(), change_.data()};
}

void GradientScale::set(std::span<const float> beta) {
  const auto cells = static_cast<int64_t>(many_.size());
  if (cells == 0) return;
  const float one = beta.front();
  const int64_t chunks = (cells + kChunk - 1) / kChunk;
  int64_t begin = chunks, end = 0;  // of the chunks that have another number
  // clang-format off
#pragma omp parallel for schedule(static) reduction(min : begin) reduction(max : end) \
    if (chunks >= kParallelMin)
  // clang-format on
  for (int64_t chunk = 0; chunk < chunks; ++chunk) {
    if (all_are(chunk_of(beta, chunk), one)) continue;
    begin = std::min(begin, chunk);
    end = std::max(end, chunk + 1);
  }
#pragma omp parallel for schedule(static) if (end - begin >= kParallelMin)
  for (int64_t chunk = begin; chunk < end; ++chunk)
    std::ranges::copy(chunk_of(beta, chunk), many_.data() + chunk * kChunk);
  view_.was_uniform = view_.is_uniform;
  view_.is_uniform = begin >= end;
  view_.before = view_.one;
  view_.one = one;
  view_.begin = begin * kChunk;
  view_.end = end * kChunk;
}

}  // namespace burnish::cuda
