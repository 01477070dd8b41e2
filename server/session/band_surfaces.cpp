#include "server/session/band_surfaces.h"

#include <algorithm>

#include "common/edit/wavelength.h"
#include "server/session/second_solver.h"

namespace burnish {

// The bar of exports, with room: bands are solved once, and an export takes them as they are.
static constexpr double kBandDistanceMax = 3e-7;
static constexpr int kBandCyclesMax = 500;

BandSurfaces::BandSurfaces(const Multigrid& on, const SolverOptions& options)
    : on_(on), options_(options) {}
BandSurfaces::~BandSurfaces() = default;

void BandSurfaces::want(const Fields& fields) {
  wanted_.clear();
  for (const Band& band : fields.equaliser().bands)
    wanted_.push_back(alpha_of_wavelength(on_.prepared->length_unit, band.size));
  const bool is_hold_new = std::exchange(hold_, fields.hold()) != fields.hold();
  if (std::exchange(rims_, fields.rims()) != fields.rims() || is_hold_new) {
    surfaces_.clear();
    solved_.reset();
  }
  std::erase_if(surfaces_, [&](const Surface& surface) {
    return std::ranges::find(wanted_, surface.alpha) == wanted_.end();
  });
  if (!is_solving()) solver_.reset();
}

void BandSurfaces::start_over() {
  surfaces_.clear();
  solved_.reset();
  solver_.reset();
}

const BandSurfaces::Surface* BandSurfaces::find(double alpha) const {
  const auto found = std::ranges::find(surfaces_, alpha, &Surface::alpha);
  return found == surfaces_.end() ? nullptr : &*found;
}

size_t BandSurfaces::known_count() const {
  const auto missing = std::ranges::find_if(wanted_, [&](double alpha) { return !find(alpha); });
  return static_cast<size_t>(missing - wanted_.begin());
}

std::span<const Vec3f> BandSurfaces::behind(size_t band) const {
  return find(wanted_[band - 1])->displacement;
}

// The next surface is near to the last one: the solver goes on from it.
Status BandSurfaces::begin(double alpha) {
  if (!solver_) {
    ASSIGN_OR_RETURN(solver_, make_second_solver(on_, options_));
  }
  Fields fields(*on_.prepared);
  fields.set_transfer_curve(TransferCurve(alpha));
  fields.set_gradient_scale(0);
  fields.set_hold(hold_);
  fields.set_rims(rims_);
  solver_->set_metric(fields.view());
  solved_ = alpha;
  cycles_ = 0;
  return Status::ok();
}

Result<bool> BandSurfaces::step() {
  const double alpha = wanted_[known_count()];
  if (solved_ != alpha || !solver_) RETURN_IF_ERROR(begin(alpha));
  const StepReport report = solver_->step();
  RETURN_IF_ERROR(solver_->status());
  if (report.distance > kBandDistanceMax && ++cycles_ < kBandCyclesMax) return false;
  const std::span<const Vec3f> solved = solver_->displacement();
  surfaces_.push_back({alpha, {solved.begin(), solved.end()}});
  solved_.reset();
  if (!is_solving()) solver_.reset();
  return true;
}

uint64_t BandSurfaces::byte_count() const {
  uint64_t bytes = solver_ ? solver_->byte_count() : 0;
  for (const Surface& surface : surfaces_) bytes += surface.displacement.size() * sizeof(Vec3f);
  return bytes;
}

}  // namespace burnish
