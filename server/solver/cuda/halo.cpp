#include "server/solver/cuda/halo.h"

#include <map>
#include <string>
#include <utility>

#include "server/solver/cuda/mesh/device_halo.h"

namespace burnish::cuda {

namespace {

/// The shards, and the barrier at which they wait for each other.
class ShardBarrier {
 public:
  explicit ShardBarrier(ShardGroup group) : group_(std::move(group)) {}
  ~ShardBarrier() {
    for (const auto& [key, graph] : graphs_)
      if (graph != nullptr) cudaGraphExecDestroy(graph);
  }
  ShardBarrier(const ShardBarrier&) = delete;

  const ShardGroup& group() const { return group_; }
  std::vector<std::unique_ptr<ShardOnDevice>>& shards() { return shards_; }
  ShardOnDevice& shard(int number) { return *shards_[number]; }
  int count() const { return static_cast<int>(shards_.size()); }

  // Does together(shard) for each shard, on its stream, after what all of them have queued so far.
  template <typename Together>
  void after_all(int number, Stream& stream, void* vector, Together&& together) {
    arrive(number, stream, vector);
    group_.arrive_and_wait([&] {
      for (const auto& waiting : shards_) wait_for_all(*waiting);
      for (int other = 0; other < count(); ++other) together(*shards_[other]);
    });
  }

  template <typename T>
  Stages<T> stages_of(int depth) {
    Stages<T> stages = {};
    for (int other = 0; other < count(); ++other)
      stages.of[other] = shards_[other]->at(depth).template stage<T>();
    return stages;
  }

  void run(int number, int key, Stream& stream, const std::function<void()>& work) {
    if (!records_) return work();
    if (!seen_[number].contains(key)) {
      seen_[number][key] = true;
      return work();
    }
    arrive(number, stream, nullptr);
    const bool is_recorded = graphs_.contains(key);
    group_.arrive_and_wait([&] { is_recorded ? launch(graphs_[key]) : begin(); });
    if (is_recorded) return;
    work();
    arrive(number, stream, nullptr);
    group_.arrive_and_wait([&] {
      graphs_[key] = end();
      launch(graphs_[key]);
    });
  }

  bool all(bool here) {
    all_ = all_ && here;
    group_.arrive_and_wait([&] { agreed_ = std::exchange(all_, true); });
    return agreed_;
  }

  void prepare() { seen_.resize(shards_.size()); }
  void never_record() { records_ = false; }

 private:
  void arrive(int number, Stream& stream, void* vector) {
    ShardOnDevice& here = *shards_[number];
    here.now = &stream;
    here.vector = vector;
    mark(here);
  }

  static void mark(ShardOnDevice& of) {
    if (of.now->is_ok())
      of.now->check(cudaEventRecord(of.ready, of.now->get()), "marking a stream");
  }

  void wait(ShardOnDevice& waiting, const ShardOnDevice& other) {
    if (&waiting != &other && waiting.now->is_ok())
      waiting.now->check(cudaStreamWaitEvent(waiting.now->get(), other.ready),
                         "waiting for another device");
  }

  // A shard that failed takes the others with it: their numbers have no meaning then.
  void wait_for_all(ShardOnDevice& waiting) {
    for (const auto& other : shards_) {
      waiting.now->check(other->now->status());
      wait(waiting, *other);
    }
  }

  void begin() {
    Stream& first = *shards_[0]->now;
    if (!first.is_ok()) return;
    first.check(cudaStreamBeginCapture(first.get(), cudaStreamCaptureModeRelaxed),
                "recording a graph");
    mark(*shards_[0]);
    for (const auto& other : shards_) wait(*other, *shards_[0]);
  }

  cudaGraphExec_t end() {
    cudaGraph_t graph = nullptr;
    cudaGraphExec_t executable = nullptr;
    ShardOnDevice& first = *shards_[0];
    wait_for_all(first);
    const cudaError_t ended = cudaStreamEndCapture(first.now->get(), &graph);
    if (first.now->check(ended, "ending a graph"))
      first.now->check(
          cudaGraphInstantiate(&executable, graph, cudaGraphInstantiateFlagUseNodePriority),
          "making a graph");
    if (graph != nullptr) cudaGraphDestroy(graph);
    for (const auto& other : shards_) mark(*other);
    return executable;
  }

  // The graph comes after all that the shards have queued, and what they queue later after it.
  void launch(cudaGraphExec_t graph) {
    ShardOnDevice& first = *shards_[0];
    wait_for_all(first);
    if (first.now->is_ok())
      first.now->check(cudaGraphLaunch(graph, first.now->get()), "starting a graph");
    mark(first);
    for (const auto& other : shards_) {
      other->now->check(first.now->status());
      wait(*other, first);
    }
  }

  ShardGroup group_;
  std::vector<std::unique_ptr<ShardOnDevice>> shards_;
  std::map<int, cudaGraphExec_t> graphs_;
  std::vector<std::map<int, bool>> seen_;
  bool records_ = true, all_ = true, agreed_ = true;
};

class DeviceHalo final : public Halo {
 public:
  DeviceHalo(std::shared_ptr<ShardBarrier> barrier, int shard)
      : barrier_(std::move(barrier)), shard_(shard) {}

  int border() const override { return barrier_->group().border; }
  bool is_first() const override { return shard_ == 0; }
  bool has_patches() const override { return barrier_->group().has_patches; }

  void refresh(Stream& stream, int depth, float4* vector) override {
    bring_to_ghosts(stream, depth, vector);
  }
  void refresh(Stream& stream, int depth, float* vector) override {
    bring_to_ghosts(stream, depth, vector);
  }

  void add_up(Stream& stream, int depth, float4* vector) override {
    DepthOnDevice& here = take_turn(depth);
    copy(stream, here.ghost_count, vector + here.own, here.stage<float4>());
    barrier_->after_all(shard_, stream, vector, [&](ShardOnDevice& of) {
      DepthOnDevice& there = of.at(depth);
      add_copies(*of.now, there.sent_count, there.sent.data(), there.copy_start.data(),
                 there.copies.data(), barrier_->stages_of<float4>(depth),
                 static_cast<float4*>(of.vector));
    });
    if (depth > border()) bring_to_ghosts(stream, depth, vector);
  }

  void collect(Stream& stream, double* numbers) override {
    ShardOnDevice& here = barrier_->shard(shard_);
    if (shard_ > 0)
      pack(stream, here.border_count, here.border_from.data(), numbers, here.border_stage.data());
    barrier_->after_all(shard_, stream, numbers, [&](ShardOnDevice& of) {
      if (&of != &barrier_->shard(0))
        return scatter(*of.now, 0, of.border_from.data(), of.border_stage.data(),
                       static_cast<double*>(of.vector));
      for (int other = 1; other < barrier_->count(); ++other) {
        const ShardOnDevice& from = barrier_->shard(other);
        scatter(*of.now, from.border_count, from.border_to.data(), from.border_stage.data(),
                static_cast<double*>(of.vector));
      }
    });
  }

  OfShards share(Stream& stream, int slot, const double* mine) override {
    ShardOnDevice& here = barrier_->shard(shard_);
    const int turn = here.turn_of_slot[slot] = (here.turn_of_slot[slot] + 1) % kTurns;
    copy(stream, int64_t{OfShards::kTotals}, mine, here.totals_of(slot, turn));
    barrier_->after_all(shard_, stream, nullptr, [](ShardOnDevice&) {});
    OfShards all = {barrier_->count(), {}};
    for (int other = 0; other < all.count; ++other)
      all.totals[other] = barrier_->shard(other).totals_of(slot, turn);
    return all;
  }

  int slot_of_solver() const override {
    return static_cast<int>(barrier_->shard(shard_).turn_of_slot.size()) - 1;
  }

  void keep_largest(Stream& stream, float* number) override {
    ShardOnDevice& here = barrier_->shard(shard_);
    widen(stream, number, here.largest.data());
    const OfShards all = share(stream, slot_of_solver(), here.largest.data());
    take_largest(stream, all, number);
  }

  bool all(bool here) override { return barrier_->all(here); }
  void never_record() override { barrier_->never_record(); }
  void run_recorded(int key, Stream& stream, const std::function<void()>& work) override {
    barrier_->run(shard_, key, stream, work);
  }

 private:
  DepthOnDevice& take_turn(int depth) {
    DepthOnDevice& here = barrier_->shard(shard_).at(depth);
    here.turn = (here.turn + 1) % kTurns;
    return here;
  }

  template <typename T>
  void bring_to_ghosts(Stream& stream, int depth, T* vector) {
    DepthOnDevice& here = take_turn(depth);
    pack(stream, here.sent_count, here.sent.data(), vector, here.stage<T>());
    barrier_->after_all(shard_, stream, vector, [&](ShardOnDevice& of) {
      DepthOnDevice& there = of.at(depth);
      take_ghosts(*of.now, there.ghost_count, there.ghosts.data(), barrier_->stages_of<T>(depth),
                  static_cast<T*>(of.vector) + there.own);
    });
  }

  std::shared_ptr<ShardBarrier> barrier_;
  int shard_;
};

Status open_memory(int reader, int owner) {
  if (reader == owner) return Status::ok();
  int can = 0;
  RETURN_IF_ERROR(cuda_status(cudaDeviceCanAccessPeer(&can, reader, owner), "asking the devices"));
  if (can == 0)
    return failed_precondition("device " + std::to_string(reader) +
                               " cannot read the memory of device " + std::to_string(owner));
  RETURN_IF_ERROR(cuda_status(cudaSetDevice(reader), "choosing a device"));
  const cudaError_t opened = cudaDeviceEnablePeerAccess(owner, 0);
  if (opened != cudaErrorPeerAccessAlreadyEnabled)
    return cuda_status(opened, "opening a device's memory");
  cudaGetLastError();  // this error does not stay
  return Status::ok();
}

}  // namespace

Result<std::vector<std::unique_ptr<Halo>>> make_halos(const ShardGroup& group,
                                                      std::span<const ShardLists> shards) {
  for (const ShardLists& reader : shards)
    for (const ShardLists& owner : shards)
      RETURN_IF_ERROR(open_memory(reader.device, owner.device));
  auto barrier = std::make_shared<ShardBarrier>(group);
  Stream first(shards.front().device);
  std::vector<std::unique_ptr<Halo>> halos;
  for (size_t i = 0; i < shards.size(); ++i) {
    barrier->shards().push_back(std::make_unique<ShardOnDevice>(shards[i], shards.front(), first));
    RETURN_IF_ERROR(barrier->shards().back()->stream.status());
    halos.push_back(std::make_unique<DeviceHalo>(barrier, static_cast<int>(i)));
  }
  RETURN_IF_ERROR(first.status());
  barrier->prepare();
  return halos;
}

}  // namespace burnish::cuda
