#include "server/solver/cuda/gradient_scale.h"

#include <algorithm>

#include "server/solver/cuda/uniform.h"

namespace burnish::cuda {

static_assert(CellPaint::kStretch == kChunk);

GradientScale::GradientScale(Stream& stream, size_t cells)
    : from_(stream, cells),
      paint_(stream, cells),
      has_paint_((from_.size() + kChunk - 1) / kChunk, 0),
      is_changed_(has_paint_.size(), 0) {
  std::fill_n(from_.data(), from_.size(), kNoPaint);
  if (from_.size() > 0) paint_.upload(stream, {from_.data(), from_.size()});
  view_ = {kBetaDefault, kBetaDefault, from_.data(), paint_.data(), {}};
}

void GradientScale::set(const FieldsView& fields) {
  const CellPaint& paint = fields.paint;
  const auto chunks = static_cast<int64_t>(has_paint_.size());
#pragma omp parallel for schedule(static) if (chunks >= kParallelMin)
  for (int64_t chunk = 0; chunk < chunks; ++chunk) {
    is_changed_[chunk] = (has_paint_[chunk] || paint.is_painted[chunk]) && copy_chunk(paint, chunk);
    has_paint_[chunk] = paint.is_painted[chunk];
  }
  list_changed();
  view_.slider_before = view_.slider;
  view_.slider = fields.gradient_scale;
}

// Returns whether anything there is new.
bool GradientScale::copy_chunk(const CellPaint& paint, int64_t chunk) {
  const std::span follow = chunk_of(paint.follow, chunk), own = chunk_of(paint.own, chunk);
  Paint* to = from_.data() + chunk * kChunk;
  bool is_new = false;
  for (size_t c = 0; c < follow.size(); ++c) {
    is_new |= to[c].follow != follow[c] || to[c].own != own[c];
    to[c] = {follow[c], own[c]};
  }
  return is_new;
}

void GradientScale::list_changed() {
  ChunkList& list = view_.changed;
  list.count = 0;
  const auto chunks = static_cast<int32_t>(is_changed_.size());
  for (int32_t chunk = 0; chunk < chunks; ++chunk)
    if (is_changed_[chunk] && list.count++ < ChunkList::kMax) list.chunk[list.count - 1] = chunk;
  list.is_all = list.count > ChunkList::kMax;
  if (list.is_all) list.count = chunks;
}

}  // namespace burnish::cuda
