#include "server/solver/cuda/gradient_scale.h"

#include <algorithm>
#include <cstring>

namespace burnish::cuda {

namespace {

constexpr int64_t kChunk = 1024;
constexpr int64_t kParallelMin = 256;  // chunks; fewer one thread copies before others have woken

std::span<const float> chunk_of(std::span<const float> beta, int64_t chunk) {
  return beta.subspan(chunk * kChunk, std::min(beta.size() - chunk * kChunk, size_t{kChunk}));
}

bool all_are(std::span<const float> beta, float one) {
  return beta.front() == one &&
         std::memcmp(&beta[0], &beta[0] + 1, beta.size_bytes() - sizeof(float)) == 0;
}

}  // namespace

GradientScale::GradientScale(Stream& stream, size_t cells)
    : many_(stream, cells), now_(stream, cells), change_(stream, cells) {
  view_ = {0, 0, 0, many_.data(), now_.data(), change_.data()};
}

void GradientScale::set(std::span<const float> beta) {
  const auto cells = static_cast<int64_t>(many_.size());
  if (cells == 0) return;
  const float one = beta.front();
  int64_t begin = 0, end = (cells + kChunk - 1) / kChunk;
  while (begin < end && all_are(chunk_of(beta, begin), one)) ++begin;
  while (begin < end && all_are(chunk_of(beta, end - 1), one)) --end;
#pragma omp parallel for schedule(static) if (end - begin >= kParallelMin)
  for (int64_t chunk = begin; chunk < end; ++chunk)
    std::ranges::copy(chunk_of(beta, chunk), many_.data() + chunk * kChunk);
  view_.one = one;
  view_.begin = begin * kChunk;
  view_.end = end * kChunk;
}

}  // namespace burnish::cuda
