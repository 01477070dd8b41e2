#include "tests/bench/accuracy_runs.h"

namespace burnish {

namespace {

using Kind = AccuracyStop::Kind;

constexpr AccuracyStop kSettled = {Kind::kSettled, 0, 1e-4, 1e-5};
constexpr AccuracyStop kSettledCurve = {Kind::kSettled, 0, 5e-4, 5e-5};
constexpr AccuracyStop kSettledSteepCurve = {Kind::kSettled, 0, 2e-3, 2e-4};
constexpr AccuracyStop kExact = {Kind::kExact, 0, 1e-5, 1e-6};

constexpr AccuracyStop after(int frames, double max) {
  return {Kind::kFrames, frames, max, 0};
}

// Paints twelve dabs of β 0, 1 and 3 over the scan: every painted value next to every other.
Changes painted(const PreparedMesh& prepared) {
  constexpr int kDabs = 12;
  constexpr double kBetas[] = {0, 3, 1};
  Changes strokes;
  for (int i = 0; i < kDabs; ++i) {
    const Vec3d centre =
        prepared.vertices[prepared.triangles[prepared.triangles.size() / kDabs * i][0]];
    strokes.push_back(Stroke{
        {.radius = 0.12 * prepared.statistics.diagonal(), .strength = 1, .beta = kBetas[i % 3]},
        {centre}});
  }
  return strokes;
}

Stroke one_stroke(const PreparedMesh& prepared) {
  const Vec3d centre = prepared.vertices[prepared.triangles[prepared.triangles.size() / 2][0]];
  return {{.radius = 0.05 * prepared.statistics.diagonal(), .strength = 1, .beta = 2}, {centre}};
}

void add_isotropic(const PreparedMesh& prepared, double alpha, std::vector<AccuracyRun>& runs) {
  const SetTransferCurve curve{TransferCurve(alpha)};
  const std::string name = "alpha " + std::to_string(static_cast<int>(alpha));
  Changes all = painted(prepared);
  all.insert(all.begin(), {curve, SetGradientScale{0.5}});
  runs.push_back({name + ", painted", {}, all, {kSettled, kExact}});
  if (alpha < 5 || alpha > 50) return;
  runs.push_back({name + ", cold",
                  {},
                  {curve, SetGradientScale{0}},
                  {after(3, 1e-3), after(5, 1e-4), after(10, 1e-5)}});
  const Changes half = {curve, SetGradientScale{0.5}};
  runs.push_back({name + ", slider step", half, {SetGradientScale{0.6}}, {after(3, 1e-4)}});
  runs.push_back({name + ", stroke", half, {one_stroke(prepared)}, {after(3, 1e-4)}});
}

TransferCurve parsed(const char* text) {
  return TransferCurve::parse(text).value();
}

}  // namespace

TransferCurve contrast_100() {
  return parsed("-20:5,20:500");
}

TransferCurve contrast_1000() {
  return parsed("-20:1,20:1000");
}

std::vector<AccuracyRun> accuracy_runs(const PreparedMesh& prepared) {
  std::vector<AccuracyRun> runs;
  for (double alpha : {1, 5, 50, 200}) add_isotropic(prepared, alpha, runs);
  const Changes flat = {SetTransferCurve{contrast_100()}, SetGradientScale{0}};
  runs.push_back({"contrast 100, cold", {}, flat, {after(5, 1e-2), after(10, 1e-3)}});
  runs.push_back({"contrast 100", {}, flat, {kSettledCurve, kExact}});
  runs.push_back({"contrast 100, curve step",
                  flat,
                  {SetTransferCurve{parsed("-20:6.25,20:625")}},
                  {after(5, 1e-3)}});
  runs.push_back({"contrast 1000",
                  {},
                  {SetTransferCurve{contrast_1000()}, SetGradientScale{0}},
                  {kSettledSteepCurve, kExact}});
  return runs;
}

}  // namespace burnish
