#include "client/scene/likely_up.h"

#include <algorithm>
#include <optional>

namespace burnish {
namespace {

constexpr double kFlat = 0.35;         // height of land, at most, as a part of its shorter side
constexpr double kLandMetres = 50;     // diagonal of the smallest land
constexpr double kLandNumbers = 5000;  // the same without a unit: no scanner's mm
constexpr double kMapNumbers = 1e5;    // coordinates of map projections, e.g. UTM

struct NamedUnit {
  std::string_view name;
  double metres;
};
constexpr NamedUnit kUnits[] = {{"mm", 1e-3}, {"cm", 1e-2},   {"dm", 0.1},    {"m", 1},
                                {"km", 1e3},  {"in", 0.0254}, {"ft", 0.3048}, {"yd", 0.9144}};

std::optional<double> metres_of(std::string_view unit) {
  const auto found = std::ranges::find(kUnits, unit, &NamedUnit::name);
  return found == std::end(kUnits) ? std::nullopt : std::optional(found->metres);
}

bool is_wide(const Eigen::AlignedBox3d& box, std::string_view unit) {
  const double diagonal = box.diagonal().norm();
  if (const auto metres = metres_of(unit)) return diagonal * *metres >= kLandMetres;
  const double farthest = box.center().head<2>().cwiseAbs().maxCoeff();
  return diagonal >= kLandNumbers || (farthest >= kMapNumbers && diagonal >= kLandMetres);
}

}  // namespace

UpAxis likely_up(const Eigen::AlignedBox3d& box, std::string_view unit, MeshFormat format) {
  if (is_gltf(format) || box.isEmpty()) return UpAxis::kY;
  const Eigen::Vector3d sizes = box.sizes();
  const bool is_flat = sizes.z() <= kFlat * sizes.head<2>().minCoeff();
  return is_flat && is_wide(box, unit) ? UpAxis::kZ : UpAxis::kY;
}

}  // namespace burnish
