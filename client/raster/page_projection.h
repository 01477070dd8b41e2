#pragma once

#include <cstdint>
#include <span>

#include <Eigen/Geometry>

#include "client/scene/camera.h"
#include "client/scene/image.h"
#include "client/scene/page_space.h"

namespace burnish {

inline constexpr int kSubpixelBits = 8;
inline constexpr int kSubpixels = 1 << kSubpixelBits;  // a pixel's side
inline constexpr int kGuardSubpixels = 1 << 22;        // places beyond are clipped

/// A vertex in the picture. Pages that share a vertex get the same numbers.
struct ScreenVertex {
  int32_t x = 0;          ///< subpixels from the left edge
  int32_t y = 0;          ///< subpixels from the upper edge
  float nearness = 0;     ///< 1 at the near plane, 0 at the far one; linear in the picture
  int32_t is_beyond = 0;  ///< in front of the near plane or past the guard: the rest means nothing
};

/// The way from PageSpace to the picture. A row times (position, 1) gives a number; x, y and
/// nearness are divided by w.
struct PageProjection {
  using Row = Eigen::Vector4f;
  Row x, y;                     ///< pixels, from the upper left corner
  Row nearness;                 ///< as ScreenVertex
  Row w;                        ///< 1 without perspective, else the distance along the view
  Row inside;                   ///< behind the near plane where this is not negative
  Eigen::Matrix3f axes;         ///< to camera space: right, up and back as rows
  Eigen::Vector2f half_view;    ///< half the picture at distance 1, or anywhere in parallel
  Eigen::Vector4f depth_terms;  ///< distance along the view = (x + y n) / (z + w n), n: nearness
  ImageSize size;
  bool is_parallel = false;
  Vec3f eye = Vec3f::Zero();  ///< PageSpace; in parallel the direction to it

  Vec3f to_eye(const Vec3f& from) const { return is_parallel ? eye : Vec3f(eye - from); }
};

PageProjection make_page_projection(const PageSpace& space, const Camera& camera,
                                    const ImageSize& size);

/// Projects vertices. Needs: room for as many in `to`.
void project_vertices(const PageProjection& projection, std::span<const Vec3f> positions,
                      ScreenVertex* to);

/// A part of the picture's columns: first..end-1.
struct ColumnRange {
  int first = 0;
  int end = 0;
};

/// Bounds of a box in the picture: pixels, both ends belong to it. Empty: nowhere.
struct ScreenBox {
  int left = 0, top = 0, right = -1, bottom = -1;
  float nearness = 1;  ///< no point of the box is nearer
  bool is_empty() const { return left > right || top > bottom; }
};

ScreenBox project_box(const PageProjection& projection, const Eigen::AlignedBox3f& box,
                      const ColumnRange& columns);

}  // namespace burnish
