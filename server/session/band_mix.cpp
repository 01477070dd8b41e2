#include "server/session/band_mix.h"

#include <algorithm>

namespace burnish {
namespace {

/// A surface behind a band, and the gains before and behind it.
struct Term {
  std::span<const Vec3f> surface;
  size_t band;                  // before it, from 1
  float before = 1, after = 1;  // sliders
};

}  // namespace

// A corner has the mean of its cells.
BandMix::PaintedGain BandMix::gain_of(const PaintLayer& layer) const {
  PaintedGain gain;
  gain.follow.assign(grid_.corners.size(), 1);
  gain.own.assign(grid_.corners.size(), 0);
#pragma omp parallel for schedule(static)
  for (size_t corner = 0; corner < grid_.corners.size(); ++corner) {
    float follow = 0, own = 0;
    int cells = 0;
    for (const int32_t cell : grid_.cells_of_corner[corner]) {
      if (cell == kNone) continue;
      follow += 1 - layer.weight[cell];
      own += layer.weight[cell] * layer.value[cell];
      ++cells;
    }
    if (cells == 0) continue;
    gain.follow[corner] = follow / static_cast<float>(cells);
    gain.own[corner] = own / static_cast<float>(cells);
  }
  return gain;
}

void BandMix::update_paint(const Fields& fields) {
  if (fields.paint_versions().gains == painted_version_) return;
  painted_version_ = fields.paint_versions().gains;
  for (size_t band = 1; band <= kBandsMax; ++band) {
    const PaintLayer* layer = fields.gain_paint(band);
    painted_[band - 1] = layer ? gain_of(*layer) : PaintedGain{};
  }
}

std::span<const Vec3f> BandMix::of(std::span<const Vec3f> solved, const Fields& fields,
                                   const BandSurfaces& surfaces) {
  const size_t known = surfaces.known_count();
  if (known == 0) return solved;
  update_paint(fields);
  const auto slider = [&](size_t band) {
    return band > known ? 1 : static_cast<float>(fields.equaliser().gain(band));
  };
  const auto paint = [&](size_t band) -> const PaintedGain* {
    return band > known || painted_[band - 1].own.empty() ? nullptr : &painted_[band - 1];
  };
  std::vector<Term> terms;
  for (size_t band = 1; band <= known; ++band)
    if (slider(band) != slider(band + 1) || paint(band) || paint(band + 1))
      terms.push_back({surfaces.behind(band), band, slider(band), slider(band + 1)});
  if (terms.empty()) return solved;
  const auto gain_at = [](float slider_gain, const PaintedGain* painted, size_t corner) {
    return painted ? slider_gain * painted->follow[corner] + painted->own[corner] : slider_gain;
  };
  sum_.resize(solved.size());
#pragma omp parallel for schedule(static)
  for (size_t corner = 0; corner < solved.size(); ++corner) {
    Vec3f sum = solved[corner];
    for (const Term& term : terms)
      sum += (gain_at(term.after, paint(term.band + 1), corner) -
              gain_at(term.before, paint(term.band), corner)) *
             term.surface[corner];
    sum_[corner] = sum;
  }
  return sum_;
}

uint64_t BandMix::byte_count() const {
  uint64_t bytes = sum_.size() * sizeof(Vec3f);
  for (const PaintedGain& gain : painted_)
    bytes += (gain.follow.size() + gain.own.size()) * sizeof(float);
  return bytes;
}

}  // namespace burnish
