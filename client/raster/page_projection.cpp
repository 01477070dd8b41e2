#include "client/raster/page_projection.h"

#include <algorithm>
#include <cmath>

#include "common/base/dispatch.h"

namespace burnish {

static Eigen::Matrix4d to_camera(const PageSpace& space, const Camera& camera) {
  Eigen::Matrix4d centre = Eigen::Matrix4d::Identity();
  centre.topRightCorner<3, 1>() = space.centre;
  Eigen::Matrix4d seen = view_matrix(camera) * centre;
  seen.topRightCorner<3, 1>() /= space.unit;
  return seen;
}

PageProjection make_page_projection(const PageSpace& space, const Camera& camera,
                                    const ImageSize& size) {
  Camera scaled = camera;  // only its projection has a meaning
  scaled.distance /= space.unit;
  scaled.scene_radius /= space.unit;
  const Eigen::Matrix4d projection = projection_matrix(scaled, size.aspect());
  const Eigen::Matrix4d seen = to_camera(space, camera);
  const Eigen::Matrix4d clip = projection * seen;
  const auto row = [](const Eigen::RowVector4d& each) {
    return PageProjection::Row(each.transpose().cast<float>());
  };
  PageProjection made;
  made.x = row(0.5 * size.width * (clip.row(3) + clip.row(0)));
  made.y = row(0.5 * size.height * (clip.row(3) - clip.row(1)));
  made.nearness = row(0.5 * (clip.row(3) - clip.row(2)));
  made.w = row(clip.row(3));
  made.inside = row(clip.row(3) + clip.row(2));
  made.axes = seen.topLeftCorner<3, 3>().cast<float>();
  made.half_view = {static_cast<float>(1 / projection(0, 0)),
                    static_cast<float>(1 / projection(1, 1))};
  // With distance a = -z of camera space: nearness = (w - z of clip space) / 2 w.
  const double by_one = 0.5 * (projection(3, 3) - projection(2, 3));
  const double by_away = -0.5 * (projection(3, 2) - projection(2, 2));
  made.depth_terms =
      Eigen::Vector4d(by_one, -projection(3, 3), -by_away, -projection(3, 2)).cast<float>();
  made.size = size;
  made.is_parallel = camera.orthographic;
  const Eigen::Matrix3d axes = seen.topLeftCorner<3, 3>();
  const Vec3d eye = -axes.transpose() * seen.topRightCorner<3, 1>();
  made.eye = (camera.orthographic ? Vec3d(axes.row(2).transpose()) : eye).cast<float>();
  return made;
}

[[gnu::always_inline]] static inline float times(const float* row, const float* at) {
  return row[0] * at[0] + row[1] * at[1] + row[2] * at[2] + row[3];
}

[[gnu::always_inline]] static inline float within_guard(float subpixels) {
  constexpr float kGuard = kGuardSubpixels;
  const float above = subpixels > -kGuard ? subpixels : -kGuard;  // a NaN ends here
  return above < kGuard ? above : kGuard;
}

// Rows: x, y, nearness, w, inside.
BURNISH_DISPATCH
static void project_all(const float* rows, const float* positions, int count, ScreenVertex* to) {
  constexpr float kGuard = kGuardSubpixels;
  for (int v = 0; v < count; ++v) {
    const float* const at = positions + 3 * v;
    const float per_w = 1 / times(rows + 12, at);
    const float x = within_guard(times(rows, at) * per_w * kSubpixels);
    const float y = within_guard(times(rows + 4, at) * per_w * kSubpixels);
    const int is_before = times(rows + 16, at) < 0;
    const int is_past = __builtin_fabsf(x) >= kGuard;
    const int is_far_off = __builtin_fabsf(y) >= kGuard;
    to[v].x = static_cast<int32_t>(x + 0.5f);
    to[v].y = static_cast<int32_t>(y + 0.5f);
    to[v].nearness = times(rows + 8, at) * per_w;
    to[v].is_beyond = is_before | is_past | is_far_off;
  }
}

void project_vertices(const PageProjection& projection, std::span<const Vec3f> positions,
                      ScreenVertex* to) {
  if (positions.empty()) return;
  Eigen::Matrix<float, 4, 5> rows;
  rows << projection.x, projection.y, projection.nearness, projection.w, projection.inside;
  project_all(rows.data(), positions.front().data(), static_cast<int>(positions.size()), to);
}

ScreenBox project_box(const PageProjection& projection, const Eigen::AlignedBox3f& box,
                      const ColumnRange& columns) {
  Eigen::Matrix<float, 4, 8> corners;
  for (int i = 0; i < 8; ++i)
    corners.col(i) << box.corner(static_cast<Eigen::AlignedBox3f::CornerType>(i)), 1.0f;
  const auto of = [&](const PageProjection::Row& row) {
    return Eigen::Array<float, 1, 8>((row.transpose() * corners).array());
  };
  const auto x = of(projection.x), y = of(projection.y), w = of(projection.w);
  const auto nearness = of(projection.nearness), inside = of(projection.inside);
  if ((inside < 0).all() || (nearness < 0).all()) return {};
  const float left = static_cast<float>(columns.first), right = static_cast<float>(columns.end);
  const float bottom = static_cast<float>(projection.size.height);
  if ((x < left * w).all() || (x > right * w).all() || (y < 0).all() || (y > bottom * w).all())
    return {};
  ScreenBox found{columns.first, 0, columns.end - 1, projection.size.height - 1, 1};
  if ((inside < 0).any()) return found;
  const auto pixel = [](float at, int low, int high) {
    return static_cast<int>(std::clamp(at, static_cast<float>(low), static_cast<float>(high)));
  };
  found.nearness = (nearness / w).maxCoeff();
  return {pixel((x / w).minCoeff() - 1, found.left, found.right),
          pixel((y / w).minCoeff() - 1, found.top, found.bottom),
          pixel((x / w).maxCoeff() + 1, found.left, found.right),
          pixel((y / w).maxCoeff() + 1, found.top, found.bottom), found.nearness};
}

}  // namespace burnish
