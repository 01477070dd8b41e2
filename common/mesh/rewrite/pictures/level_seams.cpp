#include "common/mesh/rewrite/pictures/level_seams.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <utility>
#include <vector>

#include "common/mesh/rewrite/pictures/seam_samples.h"
#include "common/mesh/rewrite/pictures/seam_system.h"
#include "common/mesh/rewrite/pictures/texture_charts.h"
#include "common/mesh/textures/texel_change.h"

namespace burnish {

namespace {

// Darker colours count as so dark: their logarithm says little.
constexpr float kDarkest = 1 / 512.F;

Vec3f levels_of(const Vec3f& light) {
  const auto exponent = static_cast<float>(1 / kShownGamma);
  return 255 * light.array().max(0).min(1).pow(exponent).matrix();
}

double median_of(std::vector<double> values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

class SeamLeveller {
 public:
  SeamLeveller(const TexturedSurface& surface, const SeamWish& wish, const FileBudget& budget)
      : surface_(surface), wish_(wish), budget_(budget) {}

  Result<LevelledSeams> level() {
    ASSIGN_OR_RETURN(charts_, find_texture_charts(surface_, budget_));
    ASSIGN_OR_RETURN(samples_, sample_seams(surface_, charts_.seams, bytes_of_charts(), budget_));
    LevelledSeams levelled;
    levelled.report.charts = charts_.charts;
    levelled.report.median_before = median_step(nullptr, &levelled.report.edges);
    levelled.factors.assign(charts_.point_count(), Vec3f::Ones());
    if (levelled.report.edges > 0) RETURN_IF_ERROR(solve(levelled));
    levelled.report.median_after = median_step(&levelled.factors, nullptr);
    levelled.points = std::move(charts_.points);
    return levelled;
  }

 private:
  uint64_t bytes_of_charts() const {
    return std::span(charts_.points).size_bytes() + std::span(charts_.corners).size_bytes() +
           std::span(charts_.begins).size_bytes() + std::span(charts_.seams).size_bytes() +
           charts_.point_count() * sizeof(Vec3f);
  }

  uint32_t point_at(const SeamEdge::Side& side, size_t end) const {
    return charts_.points[3 * size_t{side.triangle} + side.corners[end]];
  }

  float free_at(uint32_t point) const {
    if (wish_.free.empty()) return 1;
    const uint32_t corner = charts_.corners_of(point).front();
    return wish_.free[surface_.mesh.triangles[corner / 3][corner % 3]];
  }

  /// Returns the light that a sample shows. Needs: is_known().
  Vec3f light_at(size_t edge, size_t side, uint32_t sample) const {
    const Vec3f& light = samples_.lights[SeamSamples::index(edge, side, sample)];
    const uint32_t triangle = charts_.seams[edge].sides[side].triangle;
    const SurfaceTextures& textures = surface_.textures;
    return light.cwiseProduct(textures.materials[textures.triangles[triangle].material].factor);
  }

  Vec3f factor_at(const std::vector<Vec3f>& factors, const SeamEdge::Side& side,
                  double part) const {
    const auto second = static_cast<float>(part);
    return (1 - second) * factors[point_at(side, 0)] + second * factors[point_at(side, 1)];
  }

  bool is_known(size_t edge) const {
    return samples_.lights[SeamSamples::index(edge, 0, 0)][0] >= 0 &&
           samples_.lights[SeamSamples::index(edge, 1, 0)][0] >= 0;
  }

  double median_step(const std::vector<Vec3f>* factors, uint64_t* measured) const {
    std::vector<double> steps;
    for (size_t edge = 0; edge < charts_.seams.size(); ++edge) {
      if (!is_known(edge)) continue;
      double step = 0;
      for (uint32_t i = 0; i < SeamSamples::kPerEdge; ++i) {
        std::array<Vec3f, 2> lights = {light_at(edge, 0, i), light_at(edge, 1, i)};
        for (size_t side = 0; factors != nullptr && side < 2; ++side)
          lights[side].array() *=
              factor_at(*factors, charts_.seams[edge].sides[side], SeamSamples::part(i)).array();
        step += (levels_of(lights[0]) - levels_of(lights[1])).cwiseAbs().mean();
      }
      steps.push_back(step / SeamSamples::kPerEdge);
    }
    if (measured != nullptr) *measured = steps.size();
    return median_of(std::move(steps));
  }

  Status solve(LevelledSeams& levelled) {
    levelled.report.unknowns = charts_.point_count();
    if (budget_)
      RETURN_IF_ERROR(budget_(bytes_of_charts() + std::span(samples_.lights).size_bytes() +
                              SeamSystem::bytes_of(charts_)));
    ASSIGN_OR_RETURN(SeamSystem system, SeamSystem::make(charts_));
    for (size_t edge = 0; edge < charts_.seams.size(); ++edge)
      if (is_known(edge)) add_edge(edge, system);
    ASSIGN_OR_RETURN(const SeamSystem::Values logs, system.solve(budget_));
    const float most = std::log(kSeamFactorMax);
    for (uint32_t point = 0; point < charts_.point_count(); ++point) {
      const auto amount = static_cast<float>(wish_.amount) * free_at(point);
      const Vec3f log = logs.row(point).transpose().cast<float>();
      levelled.factors[point] = (amount * log.array().max(-most).min(most)).exp().matrix();
    }
    return Status::ok();
  }

  void add_edge(size_t edge, SeamSystem& system) const {
    const auto& [one, other] = charts_.seams[edge].sides;
    const SeamSystem::Points points = {point_at(one, 0), point_at(one, 1), point_at(other, 0),
                                       point_at(other, 1)};
    const Eigen::Vector4d free = {free_at(points[0]), free_at(points[1]), -free_at(points[2]),
                                  -free_at(points[3])};
    SeamSystem::Wishes wishes;
    for (uint32_t i = 0; i < SeamSamples::kPerEdge; ++i) add_sample(edge, i, free, wishes);
    system.add(points, wishes);
  }

  void add_sample(size_t edge, uint32_t sample, const Eigen::Vector4d& free,
                  SeamSystem::Wishes& wishes) const {
    const Vec3f one = light_at(edge, 0, sample), other = light_at(edge, 1, sample);
    if ((levels_of(one) - levels_of(other)).cwiseAbs().maxCoeff() > kSeamStepMax) return;
    const Vec3f step = (one.array().max(kDarkest).log() - other.array().max(kDarkest).log());
    const double part = SeamSamples::part(sample);
    const Eigen::Vector4d parts = {1 - part, part, 1 - part, part};
    wishes.add(free.cwiseProduct(parts), -step.cast<double>(), 1.0 / SeamSamples::kPerEdge);
  }

  const TexturedSurface& surface_;
  const SeamWish& wish_;
  const FileBudget& budget_;
  TextureCharts charts_;
  SeamSamples samples_;
};

}  // namespace

bool LevelledSeams::changes(uint32_t triangle) const {
  for (size_t k = 0; k < 3; ++k)
    if (factor(triangle, k) != Vec3f::Ones()) return true;
  return false;
}

std::string text_of(const SeamReport& report) {
  if (report.edges == 0) return "no seam between charts to level";
  char text[160];
  std::snprintf(text, sizeof text, "seams of %u charts levelled: median step %.1f to %.1f of 255",
                report.charts, report.median_before, report.median_after);
  return text;
}

Result<LevelledSeams> level_seams(const TexturedSurface& surface, const SeamWish& wish,
                                  const FileBudget& budget) {
  return SeamLeveller(surface, wish, budget).level();
}

}  // namespace burnish
