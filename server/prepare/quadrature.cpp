#include "server/prepare/quadrature.h"

namespace burnish {

static constexpr std::array<QuadraturePoint, 3> orbit3(double apart, double twice, double weight) {
  return {{{apart, twice, twice, weight},
           {twice, apart, twice, weight},
           {twice, twice, apart, weight}}};
}

static constexpr std::array<QuadraturePoint, 6> orbit6(double a, double b, double c,
                                                       double weight) {
  return {{{a, b, c, weight},
           {b, c, a, weight},
           {c, a, b, weight},
           {b, a, c, weight},
           {a, c, b, weight},
           {c, b, a, weight}}};
}

template <std::size_t... kSizes>
static constexpr auto join(const std::array<QuadraturePoint, kSizes>&... orbits) {
  std::array<QuadraturePoint, (kSizes + ...)> rule{};
  std::size_t next = 0;
  const auto append = [&](const auto& orbit) {
    for (const QuadraturePoint& point : orbit) rule[next++] = point;
  };
  (append(orbits), ...);
  return rule;
}

constexpr std::array<QuadraturePoint, 12> kDegree6Rule =
    join(orbit3(0.501426509658179, 0.2492867451709105, 0.116786275726379),
         orbit3(0.873821971016996, 0.063089014491502, 0.050844906370207),
         orbit6(0.053145049844817, 0.310352451033784, 0.636502499121399, 0.082851075618374));

}  // namespace burnish
