#include "client/tools/colours.h"

#include <algorithm>
#include <cmath>

namespace burnish {

static constexpr double kFullRedBeta = 3;

float signed_part_of_beta(double beta) {
  if (beta <= 1) return static_cast<float>(std::max(beta, 0.0) - 1);
  return static_cast<float>(std::min((beta - 1) / (kFullRedBeta - 1), 1.0));
}

float signed_part_of_kappa(double kappa, double range) {
  return static_cast<float>(std::clamp(std::asinh(kappa) / std::asinh(range), -1.0, 1.0));
}

double beta_of_signed_part(double part) {
  return part <= 0 ? 1 + part : 1 + part * (kFullRedBeta - 1);
}

double kappa_of_signed_part(double part, double range) {
  return std::sinh(part * std::asinh(range));
}

Vec3f blue_to_red(float signed_part) {
  static const Vec3f kBlue(0.20f, 0.44f, 0.86f), kGrey(0.80f, 0.80f, 0.80f),
      kRed(0.86f, 0.22f, 0.18f);
  const float part = std::clamp(signed_part, -1.0f, 1.0f);
  return kGrey + std::abs(part) * ((part < 0 ? kBlue : kRed) - kGrey);
}

Vec3f colour_of_hex(uint32_t hex) {
  return Vec3f(float(hex >> 16 & 255), float(hex >> 8 & 255), float(hex & 255)) / 255;
}

}  // namespace burnish
