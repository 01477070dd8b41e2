#include "server/solver/cuda/cuda_backend.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "common/base/side_by_side.h"
#include "server/solver/cuda/assembly/assembly.h"
#include "server/solver/cuda/assembly/cell_shares.h"
#include "server/solver/cuda/assembly/combined_cells.h"
#include "server/solver/cuda/assembly/constraint.h"
#include "server/solver/cuda/assembly/device_alpha.h"
#include "server/solver/cuda/assembly/device_target.h"
#include "server/solver/cuda/assembly/gradient_scale.h"
#include "server/solver/cuda/assembly/signal.h"
#include "server/solver/cuda/assembly/touched_lists.h"
#include "server/solver/cuda/device/graphs.h"
#include "server/solver/cuda/device/placement.h"
#include "server/solver/cuda/device_depth.h"
#include "server/solver/cuda/halo.h"
#include "server/solver/cuda/krylov/conjugate_gradients.h"
#include "server/solver/cuda/mesh/device_mesh.h"
#include "server/solver/cuda/products/coarsest.h"
#include "server/solver/cuda/products/transfer.h"
#include "server/solver/cuda/read_matrices.h"
#include "server/solver/cuda/readout.h"
#include "server/solver/cuda/smoothers/patch_solver.h"
#include "server/solver/cuda/smoothers/smoother.h"

namespace burnish {

namespace cuda {

namespace {

// Graphs beyond the keys of run_recorded().
constexpr int kMetricGraph = -1;
constexpr int kSameRatiosGraph = -2;
constexpr int kLocalMetricGraph = -3;
constexpr int kLocalSameRatiosGraph = -4;

// With more changed cells all matrices are made anew, and nothing looks for what they touch.
constexpr size_t kWholeFromOneIn = 8;
// Estimates of λmax are of the last whole metric: local ones may change one cell in so many
// together.
constexpr size_t kEstimatedAnewFromOneIn = 2;

// For a new metric's kernels, many of which run side by side: room for six blocks of the kernels
// that assemble rows.
constexpr int kSharedBesideOthers = 58;

class CudaBackend final : public Backend {
 public:
  /// `halo`: to the other shards; null if there are none.
  CudaBackend(std::shared_ptr<const DeviceMesh> mesh, Smoother smoother, Halo* halo)
      : mesh_(std::move(mesh)),
        halo_(halo),
        stream_(mesh_->device),
        coarse_offset_(mesh_->on.hierarchy->coarsest),
        alpha_(stream_),
        beta_(stream_, cells()),
        gradients_(stream_, CellGradients::kNumbers * cells()),
        gradient_rests_(stream_, needs_all_digits() ? CellGradients::kRests * cells() : 0),
        combined_(stream_, mesh_->on.hierarchy->depths.back().number_count()),
        coarse_combined_(stream_, numbers_of_coarse_depths()),
        kept_inverses_(stream_, numbers_of_kept_inverses()),
        pinning_(stream_, mesh_->depths.size()),
        anisotropy_(stream_, 1) {
    for (const DeviceTopology& topology : mesh_->depths)
      depths_.emplace_back(stream_, topology.view(), digits_of_next_depth());
    for (size_t i = 1; i < depths_.size(); ++i)
      smoothers_.push_back(make_smoother(smoother, stream_, mesh_->on.hierarchy->depths[i],
                                         depths_[i].view(),
                                         mesh_->on.plan->needs_all_digits(coarse_offset_ + i),
                                         is_split(coarse_offset_ + i) ? halo_ : nullptr));
    if (has_coarsest())
      coarsest_.emplace(stream_, mesh_->on.hierarchy->depths.front(), depths_.front().view());
    if (halo_ != nullptr && !is_on_device()) halo_->never_record();
    if (mesh_->reach) touched_ = TouchedLists(stream_, *mesh_->reach);
    patches_.emplace(stream_, finest(), mesh_->on.plan->patches, mesh_->patches.view());
    outer_.emplace(stream_, finest(), mesh_->evaluation.data(), mesh_->evaluation.size(), halo_,
                   mesh_->on.hierarchy->finest);
  }

  /// Returns whether no step needs the host's arrays: it does for a coarsest depth of many pieces.
  bool is_on_device() const { return !has_coarsest() || coarsest_->on_device(); }

  std::string_view name() const override { return "cuda"; }
  Status status() const override { return stream_.status(); }

  uint64_t byte_count() const override {
    uint64_t bytes = readout_.byte_count() + outer_->byte_count() +
                     (coarsest_ ? coarsest_->byte_count() : 0) + alpha_.byte_count() +
                     beta_.byte_count() + target_.byte_count() + gradients_.byte_count() +
                     gradient_rests_.byte_count() + signal_.byte_count() + combined_.byte_count() +
                     coarse_combined_.byte_count() + kept_inverses_.byte_count() +
                     touched_.byte_count() + patches_->byte_count();
    for (const DeviceDepth& depth : depths_) bytes += depth.byte_count();
    for (const auto& smoother : smoothers_) bytes += smoother->byte_count();
    return bytes;
  }

  void set_signal(std::span<const Vec3f> signal) override {
    signal_ = DeviceArray<float3>::copy_of(stream_, signal);
    stream_.synchronize();
  }

  bool set_metric(const MetricView& metric) override {
    stream_.synchronize();
    if (!stream_.is_ok()) return true;
    alpha_.set(stream_, metric);
    const bool is_isotropic =
        halo_ == nullptr ? metric.is_isotropic() : halo_->all(metric.is_isotropic());
    const bool same_ratios = std::exchange(all_ratios_are_one_, is_isotropic) && is_isotropic;
    const bool is_local = find_touched();
    stream_.share_memory(kSharedBesideOthers);
    if (is_local)
      make_touched_matrices(same_ratios);
    else
      make_matrices(same_ratios);
    stream_.share_memory(Stream::kAsItSuits);
    if (signal_.size() > 0 && !same_ratios)
      make_signal_gradients(stream_, mesh_->integrals(), metric_with(gradients()), finest(),
                            signal_.data(), outer_->constraint().per_slider);
    gradients_are_new_ |= !same_ratios;
    return !is_local;
  }

  void start_over() override {
    for (const auto& smoother : smoothers_) smoother->start_over();
    outer_->start_over();
    all_ratios_are_one_ = false;
    is_first_metric_ = must_be_whole_ = true;
  }

  // Recorded graphs keep the usual regularisation.
  void fall_back() override {
    if (!stream_.is_ok()) return;
    for (const auto& smoother : smoothers_) smoother->be_careful(true);
    assemble_matrices({});
    for (const auto& smoother : smoothers_) smoother->be_careful(false);
    must_be_whole_ = true;
    outer_->start_over();
  }

  void set_constraint(const FieldsView& fields) override {
    if (!stream_.is_ok()) return;
    beta_.set(fields);
    target_.set(stream_, fields.target);
    assemble_constraint(stream_, finest(), gradients(), beta_.view(), target_.view(),
                        std::exchange(gradients_are_new_, false), outer_->constraint(),
                        outer_->residual());
    outer_->refresh_residual();
    stream_.synchronize();
  }

  void run_recorded(int key, const std::function<void()>& work) override {
    run_on_device(key, work);
  }

  void relax_from_zero(int depth) override {
    smoother(depth).relax_from_zero();
    if (depth == mesh_->on.hierarchy->finest) relax_patches(&PatchSolver::relax_forwards);
  }
  void relax(int depth) override {
    if (depth == mesh_->on.hierarchy->finest) relax_patches(&PatchSolver::relax_backwards);
    smoother(depth).relax();
  }
  void restrict_residual(int depth) override {
    compute_residual(stream_, at(depth));
    restrict_to_coarse(stream_, at(depth), at(depth - 1));
    if (is_split(depth)) halo_->add_up(stream_, depth - 1, at(depth - 1).f);
  }
  void prolong_correction(int depth) override {
    if (is_split(depth) && !is_split(depth - 1))
      halo_->refresh(stream_, depth - 1, at(depth - 1).x);
    add_prolonged(stream_, at(depth - 1), at(depth));
    if (is_split(depth)) halo_->refresh(stream_, depth, at(depth).x);
  }
  void solve_coarsest() override { coarsest_->solve(); }
  void restrict_from_zero(int depth) override {
    cuda::restrict_from_zero(stream_, at(depth), at(depth - 1));
    if (is_split(depth)) halo_->add_up(stream_, depth - 1, at(depth - 1).f);
  }

  void recompute_residual() override { outer_->recompute_residual(); }
  void rescale() override { outer_->rescale(); }
  void update_direction(bool restart) override { outer_->update_direction(restart); }
  void advance() override { outer_->advance(); }

  Measures measure() const override {
    const ConjugateGradients::Scalars sums = outer_->measure();
    Measures measures;
    measures.energy = sums.energy;
    measures.residual = sums.constraint > 0 ? std::sqrt(sums.residual / sums.constraint) : 0.0;
    measures.preconditioned_residual = sums.z_dot_r[0] + sums.z_dot_r[1] + sums.z_dot_r[2];
    measures.moved_max = std::sqrt(static_cast<double>(sums.moved_squared_max));
    measures.curvature = *std::ranges::min_element(sums.p_dot_q);
    measures.direction_energy = sums.p_dot_q[0] + sums.p_dot_q[1] + sums.p_dot_q[2];
    return measures;
  }

  std::span<const Vec3f> displacement() override {
    return readout_.displacement(finest(), outer_->displacement().data());
  }
  std::span<const Vec3f> vertex_displacement() override {
    return readout_.vertex_displacement(finest(), outer_->displacement().data(), mesh_->evaluation);
  }

  // read_matrices()
  std::vector<NamedBits> read() {
    std::vector<NamedBits> read;
    for (size_t i = 0; i < depths_.size(); ++i) {
      const std::string name = "depth " + std::to_string(coarse_offset_ + i);
      depths_[i].read(stream_, name, read);
      if (i > 0) smoothers_[i - 1]->read(name, read);
    }
    if (coarsest_) coarsest_->read(read);
    patches_->read(read);
    const auto corners = static_cast<size_t>(finest().topology.corner_count);
    read_bits(stream_, "row sums", outer_->row_sum(), corners, read);
    read_bits(stream_, "constraint of the slider", outer_->constraint().per_slider, corners, read);
    read_bits(stream_, "anisotropy", anisotropy_, read);
    return read;
  }

 private:
  // Functions with hardly any energy occur at weak and flat parts. In products of the finest depth
  // the packed entries' and rests' errors would be larger than that energy.
  DeviceDepth::Digits digits_of_next_depth() const {
    using enum DeviceDepth::Digits;
    const bool is_finest = depths_.size() + 1 == mesh_->depths.size();
    const bool is_exact = mesh_->depths[depths_.size()].view().is_exact != nullptr;
    if (is_finest) return is_exact ? kOfADouble : kOfAFloat;
    return depths_.empty() || is_exact ? kOfAFloat : kPacked;
  }

  const Depth& at(int depth) const { return depths_[depth - coarse_offset_].view(); }
  const Depth& finest() const { return depths_.back().view(); }
  DepthSmoother& smoother(int depth) { return *smoothers_[depth - coarse_offset_ - 1]; }

  size_t cells() const { return mesh_->cells(); }
  size_t numbers_of_coarse_depths() const {
    size_t numbers = 0;
    for (size_t i = 0; i + 1 < mesh_->depths.size(); ++i)
      numbers += mesh_->on.hierarchy->depths[i].number_count();
    return numbers;
  }
  // The depths that keep their numbers between metrics need other room for inverses.
  bool keeps_numbers(size_t above) const {
    return mesh_->reach.has_value() && above >= BlockReach::kDepthsNotKept;
  }
  size_t numbers_of_kept_inverses() const {
    size_t numbers = 0;
    for (size_t above = 0; above + 1 < mesh_->depths.size(); ++above)
      if (keeps_numbers(above)) numbers += kInverseNumbers * cells_of_depth(above);
    return numbers;
  }
  size_t cells_of_depth(size_t above) const {
    return mesh_->depths[mesh_->depths.size() - 1 - above].view().cell_count;
  }
  static constexpr size_t kInverseNumbers = CellSquares<float>::kNumbers;

  bool needs_all_digits() const {
    return mesh_->on.plan->needs_all_digits(mesh_->on.hierarchy->finest);
  }
  CellGradients gradients() const {
    return {gradients_.data(), gradient_rests_.data(), finest().topology.cell_count};
  }

  Metric metric_with(const CellGradients& gradients) {
    return {alpha_.data(), mesh_->curvature.data(), mesh_->on.prepared->alpha_scale(),
            anisotropy_.data(), gradients};
  }

  bool is_split(int depth) const { return halo_ != nullptr && depth > halo_->border(); }
  // Other shards than the first one end with the border depth, where they have no rows.
  bool has_coarsest() const { return halo_ == nullptr || halo_->is_first(); }

  void relax_patches(void (PatchSolver::*work)()) {
    ((*patches_).*work)();
    if (halo_ != nullptr && halo_->has_patches())
      halo_->refresh(stream_, mesh_->on.hierarchy->finest, finest().x);
  }

  void run_on_device(int key, const std::function<void()>& work) {
    if (halo_ != nullptr) return halo_->run_recorded(key, stream_, work);
    is_on_device() ? graphs_.run(key, work) : work();
  }

  // Finds what the changed cells touch, if they are few.
  bool find_touched() {
    const std::vector<int32_t>* changed = alpha_.changed();
    return mesh_->reach && !must_be_whole_ && changed != nullptr &&
           changed->size() * kWholeFromOneIn <= cells() &&
           (changed_since_whole_ + changed->size()) * kEstimatedAnewFromOneIn <= cells() &&
           touched_.find(*changed);
  }

  void make_matrices(bool same_ratios) {
    must_be_whole_ = false;
    changed_since_whole_ = 0;
    if (std::exchange(is_first_metric_, false))  // it also starts estimates, which graphs do not
      assemble_matrices(gradients());
    else if (same_ratios)
      run_on_device(kSameRatiosGraph, [this] { assemble_matrices({}); });
    else
      run_on_device(kMetricGraph, [this] { assemble_matrices(gradients()); });
  }

  // Makes what depends on the α of the changed cells alone.
  void make_touched_matrices(bool same_ratios) {
    if (alpha_.changed()->empty()) return;
    changed_since_whole_ += alpha_.changed()->size();
    touched_.bring(stream_);
    if (same_ratios)
      run_on_device(kLocalSameRatiosGraph, [this] { assemble_matrices({}, &touched_); });
    else
      run_on_device(kLocalMetricGraph, [this] { assemble_matrices(gradients(), &touched_); });
  }

  // Makes the matrices of all depths, or their touched blocks. A depth's combined integrals come
  // from the depth below. The coarsest depth waits for that chain; matrices and smoothers are made
  // next to it. The finest matrix does not wait for the shares. Its smoother does, because it
  // overwrites their sources.
  void assemble_matrices(const CellGradients& gradients, const TouchedLists* local = nullptr) {
    const CellSquares<double> combined = {combined_.data(), finest().topology.cell_count};
    const Metric metric = metric_with(gradients);
    const BesideMatrix beside = {outer_->row_sum(), gradients, outer_->constraint().per_slider};
    const auto touched = [&](size_t above) {
      return local != nullptr ? local->at(depths_.size() - 1 - above) : Touched();
    };
    anisotropy_.clear(stream_);
    if (local != nullptr) find_anisotropy(stream_, metric, combined.cells);
    if (smoothers_.empty()) {
      combine_integrals(stream_, mesh_->integrals(), metric, combined);
      assemble_coarsest(combined, beside, {});
    } else {
      CellSquares<double> cells = {coarse_combined_.data(), topology(1).cell_count};
      combine_integrals(stream_, mesh_->integrals(), mesh_->sheets.view(), metric, combined,
                        topology(0), topology(1), cells, touched(0).parts);
      if (halo_ != nullptr) halo_->keep_largest(stream_, anisotropy_.data());
      start_matrix(0, combined, beside, touched(0));
      add_shares(stream_, topology(1).shares, combined, cells, touched(1).parts);
      collect_at_border(1, cells);
      smoothers_.back()->fork();
      start_smoother(0, combined, touched(0));
      for (size_t above = 2; above < depths_.size(); ++above) {
        const CellSquares<double> coarse = {cells.numbers + topology(above - 1).number_count,
                                            topology(above).cell_count};
        down_sample(stream_, topology(above - 1), topology(above), cells, coarse,
                    touched(above).parts);
        collect_at_border(above, coarse);
        start_matrix(above - 1, cells, {}, touched(above - 1));
        start_smoother(above - 1, cells, touched(above - 1));
        cells = coarse;
      }
      if (has_coarsest()) assemble_coarsest(cells, {}, touched(depths_.size() - 1));
    }
    if (!smoothers_.empty()) patches_->factor(smoothers_.back()->beside(), touched(0).rows);
    for (const auto& smoother : smoothers_) smoother->finish_set_up();
    if (halo_ != nullptr)
      halo_->refresh(stream_, halo_->border(), at(halo_->border()).inverse_diagonal);
  }

  // `above`: how many depths above the finest.
  void collect_at_border(size_t above, const CellSquares<double>& cells) {
    if (halo_ != nullptr &&
        mesh_->on.hierarchy->finest - static_cast<int>(above) == halo_->border())
      halo_->collect(stream_, cells.numbers);
  }

  // `above`: how many depths above the finest.
  const Depth& view(size_t above) const { return depths_[depths_.size() - 1 - above].view(); }
  const Topology& topology(size_t above) const { return view(above).topology; }

  DepthSmoother& smoother_above(size_t above) { return *smoothers_[smoothers_.size() - 1 - above]; }

  // Makes the matrix from the depth's combined integrals, next to the stream's other work.
  // Touched rows alone are no product with the probe.
  void start_matrix(size_t above, const CellSquares<double>& cells, const BesideMatrix& beside,
                    const Touched& touched) {
    DepthSmoother& smoother = smoother_above(above);
    const float4* probe = touched.rows.lists == nullptr ? smoother.probe() : nullptr;
    assemble(smoother.fork(), cells, view(above), beside, probe, pinning_.data() + above,
             touched.rows);
  }

  void start_smoother(size_t above, const CellSquares<double>& cells, const Touched& touched) {
    const CellSquares<float> inverses = {room_for_inverses(above, cells), cells.cells};
    if (touched.rows.lists == nullptr)
      smoother_above(above).set_up(inverses, anisotropy_.data());
    else
      smoother_above(above).update(inverses, anisotropy_.data(), touched);
  }

  // The smoother works in the place of a depth's numbers if the depth does not keep them.
  float* room_for_inverses(size_t above, const CellSquares<double>& cells) const {
    if (!keeps_numbers(above)) return reinterpret_cast<float*>(cells.numbers);
    float* room = kept_inverses_.data();
    for (size_t finer = BlockReach::kDepthsNotKept; finer < above; ++finer)
      room += kInverseNumbers * cells_of_depth(finer);
    return room;
  }

  void assemble_coarsest(const CellSquares<double>& cells, const BesideMatrix& beside,
                         const Touched& touched) {
    assemble(stream_, cells, depths_[0].view(), beside, nullptr,
             pinning_.data() + smoothers_.size(), touched.rows);
    coarsest_->factor();
  }

  std::shared_ptr<const DeviceMesh> mesh_;
  Halo* halo_;
  Stream stream_;
  int coarse_offset_;
  Graphs graphs_{stream_};
  DeviceAlpha alpha_;
  bool all_ratios_are_one_ = false;  // of α1 and α2
  bool is_first_metric_ = true;
  bool must_be_whole_ = true;       // the next metric
  size_t changed_since_whole_ = 0;  // cells, counted each time
  TouchedLists touched_;
  GradientScale beta_;
  DeviceTarget target_;
  DeviceArray<float> gradients_, gradient_rests_;  // CellGradients
  DeviceArray<float3> signal_;                     // empty: the surface's own places
  DeviceArray<double> combined_;         // numbers of the finest depth: CellSquares, then sheets
  DeviceArray<double> coarse_combined_;  // other depths, the finest first: CellSquares, then ties
  DeviceArray<float>
      kept_inverses_;             // of the coarse depths that keep their numbers, the finest first
  DeviceArray<Pinning> pinning_;  // the finest first
  DeviceArray<float> anisotropy_;
  std::vector<DeviceDepth> depths_;                        // the coarsest first
  std::vector<std::unique_ptr<DepthSmoother>> smoothers_;  // none at the coarsest
  std::optional<PatchSolver> patches_;                     // of the finest
  std::optional<CoarsestSolver> coarsest_;
  std::optional<ConjugateGradients> outer_;
  Readout readout_{stream_};
  bool gradients_are_new_ = true;  // since the last set_constraint()
};

}  // namespace

std::vector<NamedBits> read_matrices(Backend& backend) {
  return dynamic_cast<CudaBackend&>(backend).read();
}

}  // namespace cuda

static Status must_have(Smoother smoother) {
  if (std::ranges::find(kCudaSmoothers, smoother) != std::end(kCudaSmoothers)) return Status::ok();
  std::string all;
  for (const Smoother one : kCudaSmoothers)
    all += (all.empty() ? "" : " and ") + std::string(name_of(one));
  return unimplemented("smoother " + std::string(name_of(smoother)) + ": the CUDA backend has " +
                       all + " only");
}

Result<std::unique_ptr<Backend>> make_cuda_backend(Multigrid on, Smoother smoother) {
  RETURN_IF_ERROR(cuda_device().status());
  RETURN_IF_ERROR(must_have(smoother));
  const int device = least_loaded(cuda_memory_by_device());
  ASSIGN_OR_RETURN(auto mesh, cuda::device_mesh(device, std::move(on)));
  std::unique_ptr<Backend> backend =
      std::make_unique<cuda::CudaBackend>(std::move(mesh), smoother, nullptr);
  RETURN_IF_ERROR(backend->status());
  return backend;
}

static Result<std::unique_ptr<Backend>> make_shard(CudaShard& shard,
                                                   std::span<const CellIntegrals> integrals,
                                                   int device, cuda::Halo& halo) {
  ASSIGN_OR_RETURN(
      auto mesh, cuda::device_mesh_of_shard(device, std::move(shard.on), {integrals, shard.cells}));
  auto backend = std::make_unique<cuda::CudaBackend>(mesh, Smoother::kSchwarz, &halo);
  RETURN_IF_ERROR(backend->status());
  if (backend->is_on_device()) mesh->forget_arrays();
  return std::unique_ptr<Backend>(std::move(backend));
}

Result<CudaShards> make_cuda_shards(const CudaShardGroup& group, std::span<CudaShard> shards) {
  static_assert(kCudaShardsMax == cuda::OfShards::kMax);
  RETURN_IF_ERROR(cuda_device().status());
  const size_t devices = cuda_memory_by_device().size();
  std::vector<cuda::ShardLists> lists;
  for (size_t i = 0; i < shards.size(); ++i)
    lists.push_back({static_cast<int>(i % devices), shards[i].on.hierarchy.get(), shards[i].depths,
                     shards[i].border});
  ASSIGN_OR_RETURN(
      auto halos,
      cuda::make_halos({group.border, group.has_patches, group.arrive_and_wait}, lists));
  CudaShards made;
  made.backends.resize(shards.size());
  std::vector<Status> statuses(shards.size());
  run_side_by_side(static_cast<int>(shards.size()), [&](int i) {
    auto backend = make_shard(shards[i], group.integrals, lists[i].device, *halos[i]);
    statuses[i] = backend.status();
    if (backend.is_ok()) made.backends[i] = std::move(backend).value();
  });
  for (const Status& status : statuses) RETURN_IF_ERROR(status);
  made.halos = std::make_shared<std::vector<std::unique_ptr<cuda::Halo>>>(std::move(halos));
  return made;
}

}  // namespace burnish
