#include "tests/common/sheets/made_texture.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace burnish {

namespace {

Vec3d place_on(const Page& page, size_t triangle, const Vec3d& weights) {
  Vec3d place = Vec3d::Zero();
  for (int k = 0; k < 3; ++k)
    place += weights[k] * page.positions[page.triangles[triangle][k]].cast<double>();
  return place;
}

Texel sampled_bilinearly(const Sheet& sheet, const Vec2d& at) {
  const Vec2d first = (at - Vec2d::Constant(0.5)).array().floor();
  const Vec2d part = at - Vec2d::Constant(0.5) - first;
  Texel sum = Texel::Zero();
  for (int y = 0; y < 2; ++y)
    for (int x = 0; x < 2; ++x) {
      const auto column = static_cast<size_t>(first.x()) + x;
      const auto row = static_cast<size_t>(first.y()) + y;
      const Rgba8& texel = sheet.texels.at(row * sheet.layout.width + column);
      const double weight = (x == 0 ? 1 - part.x() : part.x()) * (y == 0 ? 1 - part.y() : part.y());
      sum += static_cast<float>(weight) * Texel(texel[0], texel[1], texel[2], texel[3]);
    }
  return sum;
}

}  // namespace

Texel pattern_at(const Vec3d& position, double wave) {
  const Vec3d turn = position * (2 * std::numbers::pi / wave);
  const double red = std::sin(turn.x()) * std::cos(0.7 * turn.y());
  const double green = std::sin(0.8 * turn.x() + 0.6 * turn.y());
  const double blue = std::cos(0.5 * (turn.x() - turn.y()) + 0.3 * turn.z());
  return Texel(static_cast<float>(128 + 100 * red), static_cast<float>(128 + 100 * green),
               static_cast<float>(128 + 100 * blue), 255);
}

BakeSource pattern_on(const Page& page, double wave) {
  BakeSource source;
  for (const PageTriangle& triangle : page.triangles) {
    auto& corners = source.triangles.emplace_back();
    for (int k = 0; k < 3; ++k) corners[k] = page.positions[triangle[k]].cast<double>();
  }
  source.texel = [page, wave](uint32_t triangle, const Vec3d& weights) {
    return pattern_at(place_on(page, triangle, weights), wave);
  };
  return source;
}

Sheet baked_sheet(const Page& page, const PageCharts& charts, float density,
                  const BakeSource& source, int samples_per_side) {
  Sheet sheet{.page = page.id,
              .density = density,
              .layout = lay_out_sheet(chart_sizes(page, charts, density)).value()};
  sheet.texels = bake_sheet(page, charts, {sheet.layout, density, samples_per_side}, source);
  return sheet;
}

double psnr_to_pattern(const Page& page, const PageCharts& charts, const Sheet& sheet,
                       double wave) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> part(0, 1);
  double squares = 0;
  size_t count = 0;
  for (size_t t = 0; t < page.triangles.size(); ++t)
    for (int sample = 0; sample < 20; ++sample, ++count) {
      const double root = std::sqrt(part(random));
      const double side = part(random);
      const Vec3d place = place_on(page, t, {1 - root, root * (1 - side), root * side});
      const size_t c = charts.of_triangle[t];
      const ChartMapping map =
          chart_mapping(charts.charts[c], sheet.density, sheet.layout.places[c]);
      const Texel shown = sampled_bilinearly(sheet, map.texel(place));
      squares += (shown - pattern_at(place, wave)).head<3>().squaredNorm() / 3;
    }
  return 10 * std::log10(255.0 * 255.0 * static_cast<double>(count) / squares);
}

}  // namespace burnish
