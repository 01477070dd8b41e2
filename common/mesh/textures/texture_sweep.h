#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "common/mesh/textures/surface_textures.h"
#include "common/mesh/textures/texture_footprint.h"
#include "common/mesh/textures/texture_row.h"
#include "common/picture/picture_rows.h"

namespace burnish {

/// Colours the thirds of triangles from a picture while it is decoded: keeps one row of it, and a
/// few bytes for each triangle. Rows may come in several passes.
class TextureSweep {
 public:
  /// Gets a part of a corner's mean: red, green and blue in linear light, multiplied by their
  /// weight, and the weight. All weights of a corner sum to about 1/3.
  using Add = std::function<void(uint32_t triangle, int corner, const Eigen::Array4d& part)>;

  static constexpr double kRowVisitsMax = 1 << 22;  // ten seconds of one core

  /// `triangles` have materials with this picture and coordinates. `goes_on` is asked often; false
  /// ends the work. If triangles touch more than `row_visits_max` rows in all, tall ones look at
  /// each second row, each fourth and so on. Needs: what it refers to outlives it.
  TextureSweep(const SurfaceTextures& textures, std::span<const uint32_t> triangles,
               const PictureSize& size, std::function<bool()> goes_on,
               double row_visits_max = kRowVisitsMax);

  /// Returns the memory that a sweep takes.
  static uint64_t bytes_of(size_t triangles, const PictureSize& size);

  void take(const PixelRun& run, const Add& add);

  bool is_cancelled() const { return is_cancelled_; }

 private:
  /// A triangle's rows.
  struct Visit {
    TexelRows rows;
    uint32_t triangle;
  };

  TextureFootprint footprint_of(uint32_t triangle) const;
  uint32_t log_stride_of(const TextureFootprint& footprint) const;
  void choose_strides(double excess);
  void activate(uint32_t y);
  void visit_list(std::vector<uint32_t>& list, uint32_t y, const Add& add);
  void visit(uint32_t triangle, uint32_t y, const Add& add) const;
  bool asks();

  const SurfaceTextures& textures_;
  const PictureSize size_;
  const std::function<bool()> goes_on_;
  TextureRow row_;
  std::vector<Visit> visits_;  // by first row
  size_t next_ = 0;            // of visits_
  uint32_t last_y_ = 0;
  uint32_t log_stride_max_ = 0;
  std::vector<std::vector<uint32_t>> active_{2};  // visits, by stride + row % stride
  uint32_t asked_ = 0;
  bool is_cancelled_ = false;
};

}  // namespace burnish
