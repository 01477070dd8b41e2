#include "client/raster/occlusion_rows.h"

#include <array>
#include <cmath>

namespace burnish {
namespace {

constexpr int kSteps = 12;
constexpr int kTurns = 16;
constexpr float kReach = 0.07f;  // of the picture's height

struct Step {
  int x, up;
};

/// The spirals that 4x4 pixels turn in 16 ways.
using Spirals = std::array<std::array<Step, kSteps>, kTurns>;

Spirals make_spirals(float pixels) {
  Spirals spirals;
  for (int turn = 0; turn < kTurns; ++turn)
    for (int i = 0; i < kSteps; ++i) {
      const float part = (static_cast<float>(i) + 0.5f) / kSteps;
      const float angle =
          static_cast<float>(turn) * 6.2832f / kTurns + 2.39996f * static_cast<float>(i);
      spirals[turn][i] = {static_cast<int>(std::lrint(part * pixels * std::cos(angle))),
                          static_cast<int>(std::lrint(part * pixels * std::sin(angle)))};
    }
  return spirals;
}

float occlusion_of(const GBufferPlaces& places, int x, int up,
                   const std::array<Step, kSteps>& steps, float pixels) {
  const GBufferPlace at = places.at(x, up, 0);
  if (at.away == 0) return 0;
  const float per_reach = 1 / (pixels * places.pixel_length(at));
  float sum = 0;
  for (const Step& step : steps) {
    const int to_x = x + step.x, to_up = up + step.up;
    if (to_x < 0 || to_up < 0 || to_x >= places.width() || to_up >= places.height()) continue;
    float away = 0;
    const ShadeVector other = places.position(to_x, to_up, 0, away);
    if (away == 0) continue;
    const ShadeVector to_other = other - at.position;
    const float length = length_of(to_other), far = length * per_reach;
    sum += greater(dot((1 / greater(length, 1e-9f)) * to_other, at.n) - 0.08f, 0) *
           greater(1 - far * far, 0);
  }
  return lesser(8 * sum / kSteps, 1);
}

}  // namespace

void occlude_rows(const GBufferPlaces& places, const RowRange& rows, Occlusions& occlusions) {
  const float pixels = kReach * static_cast<float>(places.height());
  const Spirals spirals = make_spirals(pixels);
  for (int row = rows.first; row < rows.end; ++row)
    for (int x = 0; x < places.width(); ++x) {
      const int up = places.height() - 1 - row;
      const auto& spiral = spirals[(x & 3) * 4 + (up & 3)];
      const float occluded = occlusion_of(places, x, up, spiral, pixels);
      occlusions[size_t(row) * places.width() + x] = static_cast<uint8_t>(occluded * 255 + 0.5f);
    }
}

}  // namespace burnish
