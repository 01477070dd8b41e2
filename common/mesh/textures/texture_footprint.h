#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "common/mesh/textures/texture_wrap.h"

namespace burnish {

/// Rows of pixels, both ends included.
struct TexelRows {
  uint32_t first = 0;
  uint32_t last = 0;
};

/// A triangle on a texture, in pixels from the top left corner of one repetition. Each corner owns
/// the points that are nearest to it in barycentric coordinates: a third.
class TextureFootprint {
 public:
  /// Needs: finite corners. More than kRepetitionsMax repetitions upwards are drawn closer
  /// together.
  TextureFootprint(const std::array<Eigen::Vector2d, 3>& corners, uint32_t height,
                   const TextureWraps& wraps);

  /// Returns the rows of the picture that it may touch.
  std::vector<TexelRows> rows() const;

  /// Returns how many rows it touches, each repetition counted.
  double row_count() const;

  /// Calls `add(corner, x0, x1, weight)` for pieces of each third that row `y` of the picture
  /// colours: the value there is the row's mean from x0 to x1. The weights of a third over all rows
  /// sum to about 1/3. With a stride above 1 each `stride`-th row stands for as many around it.
  template <typename Add>
  void for_each_piece(uint32_t y, uint32_t stride, const Add& add) const {
    const bool goes_up = is_clamped() && y < stride;
    const bool goes_down = is_clamped() && y + stride >= height_;
    const double reach = stride == 1 ? 1 : stride / 2.0;
    const double outer = stride == 1 ? 0 : 1;  // rows mix where none is left out
    for_each_copy(y, reach, [&](double centre) {
      const double begin = goes_up ? std::min(y_[low_], centre) : centre - reach;
      const double end = goes_down ? std::max(y_[high_], centre) : centre + reach;
      add_band({begin, centre, goes_up ? 1 : outer, 1, stride > 1}, add);
      add_band({centre, end, 1, goes_down ? 1 : outer, stride > 1}, add);
    });
  }

 private:
  static constexpr double kRepetitionsMax = 4;

  /// Heights between which a row has these weights at the ends, and linear ones between.
  struct Band {
    double begin, end;
    double weight_at_begin, weight_at_end;
    bool is_coarse;
  };
  using Barycentric = std::array<double, 3>;

  double height() const { return y_[high_] - y_[low_]; }
  double width() const { return std::ranges::max(x_) - std::ranges::min(x_); }
  bool is_clamped() const { return wraps_.v == TextureWrap::kClamp; }
  double period() const { return wraps_.v == TextureWrap::kMirror ? 2.0 * height_ : height_; }

  /// Calls `visit(centre)` for the height of each repetition of a row that reaches the triangle.
  template <typename Visit>
  void for_each_copy(uint32_t y, double reach, const Visit& visit) const {
    if (is_clamped()) return visit(y + 0.5);
    visit_copies(y + 0.5, reach, visit);
    if (wraps_.v == TextureWrap::kMirror) visit_copies(2.0 * height_ - 0.5 - y, reach, visit);
  }

  template <typename Visit>
  void visit_copies(double centre, double reach, const Visit& visit) const {
    centre += period() * std::ceil((y_[low_] - reach - centre) / period());
    for (; centre < y_[high_] + reach; centre += period()) visit(centre);
  }

  /// Cuts a band where the outlines of the thirds have corners: between them all is smooth.
  template <typename Add>
  void add_band(const Band& band, const Add& add) const {
    double begin = std::max(band.begin, y_[low_]);
    const double end = std::min(band.end, y_[high_]);
    for (const double bend : bends_) {
      if (bend <= begin || bend >= end) continue;
      add_span(band, begin, bend, add);
      begin = bend;
    }
    if (begin < end) add_span(band, begin, end, add);
  }

  /// Integrates over a part of a band by Gauss's rule of two points. Takes more steps where the
  /// line moves over many pixels of few rows.
  template <typename Add>
  void add_span(const Band& band, double begin, double end, const Add& add) const {
    constexpr double kStepsOfPixel = 2, kFewRows = 8;
    const double steps_max = band.is_coarse ? 4 : 16;
    constexpr std::array<double, 2> kGauss = {0.21132486540518713, 0.7886751345948129};
    const double rows = band.is_coarse ? 1 : end - begin;
    const double columns = width() * (end - begin) / height();
    const double density = kStepsOfPixel * std::min(1.0, kFewRows / height());
    const double steps = std::clamp(std::ceil(std::max(rows, density * columns)), 1.0, steps_max);
    const double step = (end - begin) / steps;
    const double slope = (band.weight_at_end - band.weight_at_begin) / (band.end - band.begin);
    for (double i = 0; i < steps; ++i)
      for (const double part : kGauss) {
        const double y = begin + (i + part) * step;
        add_line(y, step / 2 * (band.weight_at_begin + slope * (y - band.begin)), add);
      }
  }

  /// Adds the pieces of a horizontal line, which stands for so many rows.
  template <typename Add>
  void add_line(double y, double rows, const Add& add) const {
    const auto [from, to] = ends_of_line(y);
    const double weight = rows / height() * 2 * to[middle_];
    for (int corner = 0; corner < 3; ++corner) {
      const auto [begin, end] = part_of_third(from, to, corner);
      if (begin < end)
        add(corner, x_between(from, to, begin), x_between(from, to, end), weight * (end - begin));
    }
  }

  /// Returns where a line enters by the long side and leaves by a short one.
  std::array<Barycentric, 2> ends_of_line(double y) const;
  /// Returns which part of a segment, of 0 to 1, a corner owns.
  static std::array<double, 2> part_of_third(const Barycentric& from, const Barycentric& to,
                                             int corner);
  double x_between(const Barycentric& from, const Barycentric& to, double at) const;

  std::array<double, 3> x_, y_;
  std::array<double, 5> bends_;  // heights of the thirds' corners inside, from the least
  uint32_t height_;
  TextureWraps wraps_;
  int low_ = 0, middle_ = 1, high_ = 2;  // corners by y
};

}  // namespace burnish
