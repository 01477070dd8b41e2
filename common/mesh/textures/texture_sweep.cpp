#include "common/mesh/textures/texture_sweep.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

namespace burnish {

static constexpr double kRowsOfTriangleMin = 8;

static uint32_t floor_log2(double value) {
  return value < 2 ? 0 : static_cast<uint32_t>(std::ilogb(value));
}

uint64_t TextureSweep::bytes_of(size_t triangles, const PictureSize& size) {
  constexpr uint64_t kRangesMax = 2, kPlacesMax = 2;  // a vector that grows has room to spare
  return triangles * kRangesMax * kPlacesMax * (sizeof(Visit) + sizeof(uint32_t)) +
         size.width * TextureRow::kBytesPerColumn;
}

TextureSweep::TextureSweep(const SurfaceTextures& textures, std::span<const uint32_t> triangles,
                           const PictureSize& size, std::function<bool()> goes_on,
                           double row_visits_max)
    : textures_(textures), size_(size), goes_on_(std::move(goes_on)), row_(size.width) {
  visits_.reserve(triangles.size());
  double rows = 0;
  for (const uint32_t triangle : triangles) {
    if (!asks()) return;
    const TextureFootprint footprint = footprint_of(triangle);
    rows += footprint.row_count();
    for (const TexelRows& range : footprint.rows()) visits_.push_back({range, triangle});
  }
  std::ranges::sort(visits_, {}, [](const Visit& visit) { return visit.rows.first; });
  choose_strides(rows / row_visits_max);
}

void TextureSweep::choose_strides(double excess) {
  const uint32_t wanted = floor_log2(2 * excess);
  log_stride_max_ = std::min(wanted, floor_log2(size_.height / (2 * kRowsOfTriangleMin)));
  active_.resize(size_t{2} << log_stride_max_);
}

TextureFootprint TextureSweep::footprint_of(uint32_t triangle) const {
  const TexturedTriangle& textured = textures_.triangles[triangle];
  const SurfaceMaterial& material = textures_.materials[textured.material];
  std::array<Eigen::Vector2d, 3> corners;
  for (size_t k = 0; k < 3; ++k) {
    const auto& [u, v] = textures_.coordinates[textured.corners[k]];
    const Eigen::Vector2d place = material.to_picture * Eigen::Vector2d(u, v);
    corners[k] = {place.x() * size_.width, place.y() * size_.height};
  }
  return TextureFootprint(corners, size_.height, material.wraps);
}

uint32_t TextureSweep::log_stride_of(const TextureFootprint& footprint) const {
  if (log_stride_max_ == 0) return 0;
  return std::min(log_stride_max_, floor_log2(footprint.row_count() / kRowsOfTriangleMin));
}

/// Asks now and then whether to go on.
bool TextureSweep::asks() {
  constexpr uint32_t kBetween = 4096;
  if (!is_cancelled_ && ++asked_ % kBetween == 0) is_cancelled_ = !goes_on_();
  return !is_cancelled_;
}

void TextureSweep::take(const PixelRun& run, const Add& add) {
  activate(run.y);
  bool is_set = false;
  for (uint32_t log = 0; log <= log_stride_max_; ++log) {
    const uint32_t stride = uint32_t{1} << log;
    std::vector<uint32_t>& list = active_[stride + run.y % stride];
    if (list.empty()) continue;
    if (!is_set) row_.set(run);
    is_set = true;
    visit_list(list, run.y, add);
  }
}

void TextureSweep::activate(uint32_t y) {
  if (y < last_y_) {  // another pass
    for (auto& list : active_) list.clear();
    next_ = 0;
  }
  last_y_ = y;
  for (; next_ < visits_.size() && visits_[next_].rows.first <= y && asks(); ++next_) {
    const Visit& visit = visits_[next_];
    if (visit.rows.last < y) continue;
    const uint32_t stride = uint32_t{1} << log_stride_of(footprint_of(visit.triangle));
    const uint32_t scattered = (visit.triangle * 2654435761U) >> 16;  // over the rows of a stride
    active_[stride + scattered % stride].push_back(static_cast<uint32_t>(next_));
  }
}

void TextureSweep::visit_list(std::vector<uint32_t>& list, uint32_t y, const Add& add) {
  size_t kept = 0;
  for (const uint32_t active : list) {
    if (!asks()) return;
    if (visits_[active].rows.last < y) continue;
    list[kept++] = active;
    visit(visits_[active].triangle, y, add);
  }
  list.resize(kept);
}

void TextureSweep::visit(uint32_t triangle, uint32_t y, const Add& add) const {
  const TextureFootprint footprint = footprint_of(triangle);
  const SurfaceMaterial& material = textures_.materials[textures_.triangles[triangle].material];
  const uint32_t stride = uint32_t{1} << log_stride_of(footprint);
  std::array<Eigen::Array4d, 3> parts;
  parts.fill(Eigen::Array4d::Zero());
  footprint.for_each_piece(y, stride, [&](int corner, double x0, double x1, double weight) {
    parts[static_cast<size_t>(corner)] += weight * row_.mean(x0, x1, material.wraps.u);
  });
  for (int corner = 0; corner < 3; ++corner)
    if (const auto& part = parts[static_cast<size_t>(corner)]; part[3] > 0)
      add(triangle, corner, part);
}

}  // namespace burnish
