#include "server/solver/cuda/assembly/gradient_scale.h"

#include <algorithm>
#include <functional>

#include "server/solver/cuda/device/chunks.h"

namespace burnish::cuda {

static_assert(CellPaint::kStretch == kChunk);

static size_t chunk_count(size_t cells) {
  return (cells + kChunk - 1) / kChunk;
}

GradientScale::GradientScale(Stream& stream, size_t cells)
    : host_(stream, cells),
      changed_(stream, std::min(cells, size_t{ChunkList::kMax * kChunk})),
      paint_(stream, cells),
      has_paint_(chunk_count(cells), 0),
      is_changed_(chunk_count(cells), 0) {
  std::fill_n(host_.data(), host_.size(), kNoPaint);
  paint_.upload(stream, {host_.data(), host_.size()});
  view_ = {kBetaDefault, kBetaDefault, false, paint_.data(), nullptr, {}};
}

void GradientScale::set(const FieldsView& fields) {
  find_painted(fields.paint);
  const auto painted = static_cast<int64_t>(painted_.size());
#pragma omp parallel for schedule(static) if (painted >= kParallelMin)
  for (int64_t i = 0; i < painted; ++i) is_changed_[i] = take(fields.paint, painted_[i]);
  list_changed();
  gather_changed();
  view_.slider_before = view_.slider;
  view_.slider = fields.gradient_scale;
  view_.is_painted = std::ranges::any_of(has_paint_, std::identity());
}

// Few chunks have paint. So one thread, which need not wake others, has looked at all of them soon.
void GradientScale::find_painted(const CellPaint& paint) {
  painted_.clear();
  for (size_t chunk = 0; chunk < has_paint_.size(); ++chunk) {
    if (has_paint_[chunk] || paint.is_painted[chunk])
      painted_.push_back(static_cast<int32_t>(chunk));
    has_paint_[chunk] = paint.is_painted[chunk];
  }
}

// Returns whether the chunk has new paint.
bool GradientScale::take(const CellPaint& paint, int64_t chunk) {
  const std::span follow = chunk_of(paint.follow, chunk), own = chunk_of(paint.own, chunk);
  Paint* to = host_.data() + chunk * kChunk;
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
  for (size_t i = 0; i < painted_.size(); ++i)
    if (is_changed_[i] && list.count++ < ChunkList::kMax) list.chunk[list.count - 1] = painted_[i];
  list.is_all = list.count > ChunkList::kMax;
  if (list.is_all) list.count = static_cast<int32_t>(has_paint_.size());
}

// Gathers one chunk after the other: so few chunks are listed that little is read from far away.
void GradientScale::gather_changed() {
  const ChunkList& list = view_.changed;
  view_.from = list.is_all ? host_.data() : changed_.data();
  Paint* to = changed_.data();
  for (int32_t i = 0; i < list.count && !list.is_all; ++i)
    to = std::ranges::copy(chunk_of<Paint>({host_.data(), host_.size()}, list.chunk[i]), to).out;
}

}  // namespace burnish::cuda
