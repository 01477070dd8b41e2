#include "server/solver/cpu/cpu_backend.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

#include "common/base/blocks.h"
#include "server/fields/changing_alphas.h"
#include "server/solver/cpu/assembly/assembly.h"
#include "server/solver/cpu/assembly/constraint.h"
#include "server/solver/cpu/cpu_depth.h"
#include "server/solver/cpu/krylov/conjugate_gradients.h"
#include "server/solver/cpu/products/coarsest.h"
#include "server/solver/cpu/products/products.h"
#include "server/solver/cpu/products/transfer.h"
#include "server/solver/cpu/readout.h"
#include "server/solver/cpu/smoothers/patch_solver.h"
#include "server/solver/cpu/smoothers/smoother.h"
#include "server/solver/hierarchy/changed_parts.h"
#include "server/solver/hierarchy/sources.h"

namespace burnish {

namespace cpu {

namespace {

constexpr size_t kWholeFromOneIn = 3;  // with more changed cells, all matrices are made anew

double anisotropy_of(std::span<const double> ratio) {
  double most = 1;
  for (const double r : ratio) most = std::max({most, r, 1 / r});
  return most;
}

void evaluate_all(const SparseGrid& grid, std::span<const EvaluationPoint> points,
                  const std::vector<Double3>& u, std::vector<Vec3f>& moved) {
  moved.resize(points.size());
#pragma omp parallel for schedule(dynamic)
  for (size_t begin = 0; begin < points.size(); begin += kBlock)
    visit_vertices(
        grid, points, u, begin, std::min(begin + kBlock, points.size()),
        [&](size_t v, const Double3& value) { moved[v] = value.matrix().cast<float>(); });
}

class CpuBackend final : public Backend {
 public:
  CpuBackend(Multigrid on, Smoother smoother, Halo* halo)
      : on_(std::move(on)),
        halo_(halo),
        not_kept_(depths_not_kept(*on_.hierarchy, halo)),
        patches_(on_.plan->patches) {
    alphas_ = std::make_unique<ChangingAlphas>(*on_.prepared);
    depths_.reserve(on_.hierarchy->depths.size());
    for (const HierarchyDepth& topology : on_.hierarchy->depths) {
      depths_.emplace_back(topology, is_split(topology.grid.depth) ? halo_ : nullptr);
      const bool coarsest = depths_.size() == 1;
      smoothers_.push_back(coarsest ? nullptr : make_smoother(smoother, topology));
    }
    constraint_ = std::make_unique<Constraint>(*on_.prepared, depths_.back());
    outer_ = std::make_unique<ConjugateGradients>(depths_.back(), on_.hierarchy->points);
  }

  std::string_view name() const override { return "cpu"; }

  uint64_t byte_count() const override {
    uint64_t bytes = outer_->byte_count() + coarsest_.byte_count() + patches_.byte_count() +
                     constraint_->byte_count() + alphas_->byte_count() + bytes_of(displacement_) +
                     bytes_of(vertex_displacement_);
    for (const CpuDepth& depth : depths_) bytes += depth.byte_count();
    for (const auto& smoother : smoothers_) bytes += smoother ? smoother->byte_count() : 0;
    return bytes;
  }

  void set_signal(std::span<const Vec3f> signal) override { constraint_->set_signal(signal); }

  bool set_metric(const MetricView& metric) override {
    const bool was_careful = be_careful(false);
    const std::vector<int32_t> changed = alphas_->take(metric);
    constraint_->set_ratio(ratios_of(alphas_->latest()));
    double anisotropy = anisotropy_of(constraint_->ratio());
    if (halo_ != nullptr) halo_->keep_largest(anisotropy);
    const bool is_spectrum_new = take_spectrum(metric);
    for (CpuDepth& depth : depths_) {
      depth.anisotropy = static_cast<float>(anisotropy);
      depth.is_spectrum_new = is_spectrum_new;
    }
    const bool is_whole = was_careful || changes_most(changed.size());
    if (is_whole)
      make_matrices();
    else
      update_matrices(changed);
    if (depths_.front().has_rows()) coarsest_.factor(depths_.front());
    return is_whole;
  }

  void start_over() override {
    alphas_ = std::make_unique<ChangingAlphas>(*on_.prepared);
    alpha_of_spectrum_ = 0;
    constraint_->start_over();
    for (size_t i = 1; i < smoothers_.size(); ++i) smoothers_[i]->start_over();
    outer_->start_over();
  }

  void fall_back() override {
    be_careful(true);
    for (CpuDepth& depth : depths_) depth.is_spectrum_new = true;
    for (size_t i = 1; i < depths_.size(); ++i) {
      smoothers_[i]->start_over();
      smoothers_[i]->set_up(depths_[i]);
    }
    outer_->forget_steps();
  }

  void set_constraint(const FieldsView& fields) override {
    constraint_->assemble(fields, outer_->constraint(), outer_->residual());
    outer_->load_residual();
  }

  void relax_from_zero(int depth) override {
    smoother(depth).relax_from_zero(at(depth));
    if (!has_patches(depth)) return;
    patches_.relax_forwards(at(depth));
    at(depth).refresh(at(depth).x);
  }
  void relax(int depth) override {
    if (has_patches(depth)) {
      patches_.relax_backwards(at(depth));
      at(depth).refresh(at(depth).x);
    }
    smoother(depth).relax(at(depth));
  }
  void restrict_residual(int depth) override {
    compute_residual(at(depth));
    restrict_to_coarse(at(depth), at(depth).r, at(depth - 1));
    if (is_split(depth)) halo_->add_up(depth - 1, at(depth - 1).f);
  }
  void prolong_correction(int depth) override {
    if (is_split(depth) && !is_split(depth - 1)) halo_->refresh(depth - 1, at(depth - 1).x);
    add_prolonged(at(depth - 1), at(depth));
    at(depth).refresh(at(depth).x);
  }
  void solve_coarsest() override { coarsest_.solve(depths_.front()); }
  void restrict_from_zero(int depth) override {
    std::ranges::fill(at(depth).x, Float4(Float4::Zero()));
    restrict_to_coarse(at(depth), at(depth).f, at(depth - 1));
    if (is_split(depth)) halo_->add_up(depth - 1, at(depth - 1).f);
  }

  void recompute_residual() override { outer_->recompute_residual(); }
  void rescale() override { outer_->rescale(); }
  void update_direction(bool restart) override { outer_->update_direction(restart); }
  void advance() override { outer_->advance(); }
  Measures measure() const override { return outer_->measure(); }

  std::span<const Vec3f> displacement() override {
    const std::vector<Double3>& u = outer_->displacement();
    displacement_.resize(u.size());
#pragma omp parallel for schedule(static)
    for (size_t i = 0; i < u.size(); ++i) displacement_[i] = u[i].matrix().cast<float>();
    return displacement_;
  }

  std::span<const Vec3f> vertex_displacement() override {
    evaluate_all(on_.hierarchy->at(on_.hierarchy->finest).grid, on_.prepared->evaluation,
                 outer_->displacement(), vertex_displacement_);
    return vertex_displacement_;
  }

 private:
  // Returns whether it was.
  bool be_careful(bool careful) {
    for (size_t i = 1; i < smoothers_.size(); ++i) smoothers_[i]->be_careful(careful);
    return std::exchange(is_careful_, careful);
  }

  CellMetric metric() const {
    return {alphas_->latest(), alphas_->held()};
  }

  void make_matrices() {
    assemble(*on_.prepared, metric(), depths_, &outer_->matrix(), not_kept_, halo_);
    for (size_t i = 1; i < depths_.size(); ++i) smoothers_[i]->set_up(depths_[i]);
    patches_.factor(depths_.back());
  }

  // Makes what depends on the α of these cells alone. The bits are those of make_matrices().
  void update_matrices(std::span<const int32_t> cells) {
    std::vector<ChangedDepth> changed =
        find_changed_parts(*on_.prepared, *on_.hierarchy, cells, not_kept_);
    if (halo_ != nullptr) make_coarse_depths_whole(changed);
    assemble_changed(*on_.prepared, metric(), changed, depths_, &outer_->matrix(), halo_);
    for (size_t i = 1; i < depths_.size(); ++i) smoothers_[i]->update(depths_[i], changed[i].rows);
    patches_.factor(depths_.back(), changed.back().rows);
  }

  // λmax hardly moves if all cells have one α: on scans by a tenth from 1 to 50, and by a third up
  // to 1000, where its margin is more than a tenth. Returns whether λmax must be estimated again.
  bool take_spectrum(const MetricView& metric) {
    constexpr double kHoldsWithin = 1.5;
    double differs = metric.is_uniform() && metric.held.lines.empty() ? 0 : 1;
    if (halo_ != nullptr) halo_->keep_largest(differs);
    const double alpha = differs == 0 ? metric.curve->alpha(0) : 0;
    const auto [least, most] = std::minmax(alpha_of_spectrum_, alpha);
    if (least > 0 && most <= kHoldsWithin * least) return false;
    alpha_of_spectrum_ = alpha;
    return true;
  }

  // Other shards changed what this one does not know of.
  void make_coarse_depths_whole(std::span<ChangedDepth> changed) const {
    for (size_t i = 0; i < depths_.size() && !is_split(depths_[i].topology.grid.depth); ++i) {
      if (!depths_[i].has_rows()) continue;
      changed[i].rows.resize(depths_[i].corner_count());
      std::iota(changed[i].rows.begin(), changed[i].rows.end(), 0);
      if (depths_[i].topology.grid.depth == halo_->border()) continue;
      changed[i].needed.resize(part_count(depths_[i].topology));
      std::iota(changed[i].needed.begin(), changed[i].needed.end(), 0);
    }
  }

  bool is_split(int depth) const {
    return halo_ != nullptr && depth > halo_->border();
  }

  // Returns whether so many cells of all shards are worth new matrices everywhere.
  bool changes_most(size_t changed) const {
    std::array<double, 2> counts = {static_cast<double>(changed),
                                    static_cast<double>(on_.prepared->cells.size())};
    if (halo_ != nullptr) halo_->sum(counts);
    return counts[0] * kWholeFromOneIn > counts[1];
  }

  // Every shard answers the same if it asks for the finest depth of shards.
  bool has_patches(int depth) const {
    return depth == on_.hierarchy->finest && (halo_ != nullptr || patches_.count() > 0);
  }

  CpuDepth& at(int depth) {
    return depths_[depth - on_.hierarchy->coarsest];
  }
  DepthSmoother& smoother(int depth) {
    return *smoothers_[depth - on_.hierarchy->coarsest];
  }

  Multigrid on_;
  Halo* halo_;       // to the other shards; null if there are none
  size_t not_kept_;  // depths without kept numbers
  std::unique_ptr<ChangingAlphas> alphas_;
  bool is_careful_ = false;       // after fall_back()
  double alpha_of_spectrum_ = 0;  // α of all cells at the last estimate of λmax; 0 if they differed
  std::vector<CpuDepth> depths_;                           // the coarsest first
  std::vector<std::unique_ptr<DepthSmoother>> smoothers_;  // none at the coarsest
  PatchSolver patches_;                                    // of the finest
  CoarsestSolver coarsest_;
  std::unique_ptr<Constraint> constraint_;
  std::unique_ptr<ConjugateGradients> outer_;
  std::vector<Vec3f> displacement_, vertex_displacement_;  // empty until the first call
};

}  // namespace

}  // namespace cpu

std::unique_ptr<Backend> make_cpu_backend(Multigrid on, Smoother smoother) {
  return std::make_unique<cpu::CpuBackend>(std::move(on), smoother, nullptr);
}

std::unique_ptr<Backend> make_cpu_shard_backend(Multigrid on, cpu::Halo& halo) {
  return std::make_unique<cpu::CpuBackend>(std::move(on), Smoother::kSchwarz, &halo);
}

}  // namespace burnish
