#include "server/solver/multi/multi_backend.h"

#include <utility>

#include "server/solver/multi/shard_fields.h"

namespace burnish {

namespace {

class MultiBackend final : public Backend {
 public:
  MultiBackend(const Multigrid& on, ShardBackends of_shards)
      : of_(std::move(of_shards)),
        displacement_(on.hierarchy->at(on.hierarchy->finest).grid.corners.size()),
        vertex_displacement_(on.prepared->evaluation.size(), Vec3f::Zero()) {
    for (const Shard& shard : of_.shards->all) fields_.emplace_back(shard.cells);
  }

  std::string_view name() const override { return of_.backends.front()->name(); }

  uint64_t byte_count() const override {
    uint64_t bytes = (displacement_.capacity() + vertex_displacement_.capacity()) * sizeof(Vec3f);
    for (const auto& backend : of_.backends) bytes += backend->byte_count();
    for (const ShardFields& fields : fields_) bytes += fields.byte_count();
    return bytes;
  }

  Status status() const override {
    for (const auto& backend : of_.backends) RETURN_IF_ERROR(backend->status());
    return Status::ok();
  }

  void run_recorded(int key, const std::function<void()>& work) override {
    for_all([&](Backend& backend, int) { backend.run_recorded(key, work); });
  }

  void set_signal(std::span<const Vec3f> signal) override {
    for_all([&](Backend& backend, int number) {
      std::vector<Vec3f> of_shard;
      for (const int32_t corner : shard(number).corners) of_shard.push_back(signal[corner]);
      backend.set_signal(of_shard);
    });
  }

  bool set_metric(const MetricView& metric) override {
    std::vector<char> is_whole(of_.backends.size());
    for_all([&](Backend& backend, int number) {
      is_whole[number] = backend.set_metric(fields_[number].metric(metric));
    });
    return is_whole.front() != 0;
  }
  void start_over() override {
    for_all([](Backend& backend, int) { backend.start_over(); });
  }
  void fall_back() override {
    for_all([](Backend& backend, int) { backend.fall_back(); });
  }
  void set_constraint(const FieldsView& fields) override {
    for_all([&](Backend& backend, int number) {
      backend.set_constraint(fields_[number].constraint(fields));
    });
  }

  void relax_from_zero(int depth) override {
    at(depth, [=](Backend& backend) { backend.relax_from_zero(depth); });
  }
  void relax(int depth) override {
    at(depth, [=](Backend& backend) { backend.relax(depth); });
  }
  void restrict_residual(int depth) override {
    at(depth, [=](Backend& backend) { backend.restrict_residual(depth); });
  }
  void prolong_correction(int depth) override {
    at(depth, [=](Backend& backend) { backend.prolong_correction(depth); });
  }
  void solve_coarsest() override {
    at(of_.shards->border, [](Backend& backend) { backend.solve_coarsest(); });
  }
  void restrict_from_zero(int depth) override {
    at(depth, [=](Backend& backend) { backend.restrict_from_zero(depth); });
  }

  void recompute_residual() override {
    for_all([](Backend& backend, int) { backend.recompute_residual(); });
  }
  void rescale() override {
    for_all([](Backend& backend, int) { backend.rescale(); });
  }
  void update_direction(bool restart) override {
    for_all([=](Backend& backend, int) { backend.update_direction(restart); });
  }
  void advance() override {
    for_all([](Backend& backend, int) { backend.advance(); });
  }

  // All shards have the sums of all.
  Measures measure() const override { return of_.backends.front()->measure(); }

  std::span<const Vec3f> displacement() override {
    for_all([&](Backend& backend, int number) {
      const std::span<const Vec3f> u = backend.displacement();
      for (size_t i = 0; i < std::min<size_t>(shard(number).own_corners, u.size()); ++i)
        displacement_[shard(number).corners[i]] = u[i];
    });
    return displacement_;
  }
  std::span<const Vec3f> vertex_displacement() override {
    for_all([&](Backend& backend, int number) {
      const std::span<const Vec3f> moved = backend.vertex_displacement();
      for (size_t i = 0; i < moved.size(); ++i)
        vertex_displacement_[shard(number).vertices[i]] = moved[i];
    });
    return vertex_displacement_;
  }

 private:
  const Shard& shard(int number) const { return of_.shards->all[number]; }

  // Within run_recorded() each shard's thread makes the calls for its own shard.
  template <typename Call>
  void for_all(Call&& call) {
    if (const int current = of_.steps->current(); current >= 0)
      return call(*of_.backends[current], current);
    of_.steps->run([&](int number) { call(*of_.backends[number], number); });
  }

  template <typename Call>
  void at(int depth, Call&& call) {
    if (depth > of_.shards->border) return for_all([&](Backend& backend, int) { call(backend); });
    if (of_.steps->current() <= 0) call(*of_.backends.front());
  }

  ShardBackends of_;
  std::vector<ShardFields> fields_;  // per shard
  std::vector<Vec3f> displacement_, vertex_displacement_;
};

}  // namespace

std::unique_ptr<Backend> make_multi_backend(const Multigrid& on, ShardBackends of_shards) {
  return std::make_unique<MultiBackend>(on, std::move(of_shards));
}

}  // namespace burnish
