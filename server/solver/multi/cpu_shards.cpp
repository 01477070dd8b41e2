#include "server/solver/multi/cpu_shards.h"

#include <algorithm>
#include <utility>

#include "server/solver/cpu/cpu_backend.h"
#include "server/solver/cpu/halo.h"
#include "server/solver/hierarchy/sheets/irregular_rows.h"

namespace burnish {

namespace {

/// Barrier of the shards of one backend, and what they share at it.
struct ShardBarrier {
  std::shared_ptr<const Shards> shards;
  LockStep& steps;
  std::vector<void*> numbers;   // of each shard
  std::vector<double> results;  // of a sum or a maximum

  const HaloLists& lists(int shard, int depth) const {
    return shards->all[shard].halos[depth - shards->border];
  }
  int own_corners(int shard, int depth) const {
    return shards->all[shard].on.hierarchy->at(depth).own_count();
  }
};

template <typename T>
void bring_to_ghosts(const ShardBarrier& barrier, int depth) {
  for (int shard = 0; shard < barrier.shards->count(); ++shard) {
    T* to = static_cast<T*>(barrier.numbers[shard]) + barrier.own_corners(shard, depth);
    for (const auto& [owner, index] : barrier.lists(shard, depth).ghosts)
      *to++ =
          static_cast<const T*>(barrier.numbers[owner])[barrier.lists(owner, depth).sent[index]];
  }
}

template <typename T>
void add_to_owners(const ShardBarrier& barrier, int depth) {
  for (int shard = 0; shard < barrier.shards->count(); ++shard) {
    const HaloLists& lists = barrier.lists(shard, depth);
    T* own = static_cast<T*>(barrier.numbers[shard]);
    for (size_t k = 0; k < lists.sent.size(); ++k)
      for (const auto& [other, ghost] : lists.copies[k])
        own[lists.sent[k]] += static_cast<const T*>(
            barrier.numbers[other])[barrier.own_corners(other, depth) + ghost];
  }
}

// Returns where a part's numbers begin, and how many they are.
std::span<double> numbers_of(double* numbers, size_t cells, int32_t part) {
  const auto place = static_cast<size_t>(part);
  if (place < cells) return {numbers + kNumbersPerCell * place, size_t{kNumbersPerCell}};
  return {numbers + kNumbersPerCell * cells + kNumbersPerTie * (place - cells),
          size_t{kNumbersPerTie}};
}

void bring_to_first(const ShardBarrier& barrier) {
  const auto cells = [&](int shard) {
    return barrier.shards->all[shard].on.hierarchy->at(barrier.shards->border).grid.cells.size();
  };
  auto* to = static_cast<double*>(barrier.numbers[0]);
  for (int shard = 1; shard < barrier.shards->count(); ++shard) {
    auto* from = static_cast<double*>(barrier.numbers[shard]);
    const BorderLists& lists = barrier.shards->all[shard].border;
    for (size_t i = 0; i < lists.here.size(); ++i)
      std::ranges::copy(numbers_of(from, cells(shard), lists.here[i]),
                        numbers_of(to, cells(0), lists.whole[i]).begin());
  }
}

class CpuHalo final : public cpu::Halo {
 public:
  CpuHalo(std::shared_ptr<ShardBarrier> barrier, int shard)
      : barrier_(std::move(barrier)), shard_(shard) {}

  int border() const override { return barrier_->shards->border; }

  void refresh(int depth, std::span<Eigen::Array4f> vector) override {
    arrive_and_wait(vector.data(), [&] { bring_to_ghosts<Eigen::Array4f>(*barrier_, depth); });
  }
  void refresh(int depth, std::span<float> vector) override {
    arrive_and_wait(vector.data(), [&] { bring_to_ghosts<float>(*barrier_, depth); });
  }
  void add_up(int depth, std::span<Eigen::Array4f> vector) override {
    arrive_and_wait(vector.data(), [&] {
      add_to_owners<Eigen::Array4f>(*barrier_, depth);
      bring_to_ghosts<Eigen::Array4f>(*barrier_, depth);
    });
  }
  void collect(double* numbers) override {
    arrive_and_wait(numbers, [&] { bring_to_first(*barrier_); });
  }
  void sum(std::span<double> numbers) override {
    combine(numbers, [](double sum, double number) { return sum + number; });
  }
  void keep_largest(double& number) override {
    combine({&number, 1}, [](double most, double one) { return std::max(most, one); });
  }

 private:
  template <typename Together>
  void arrive_and_wait(void* numbers, Together&& together) {
    barrier_->numbers[shard_] = numbers;
    barrier_->steps.arrive_and_wait(together);
  }

  template <typename Combine>
  void combine(std::span<double> numbers, Combine&& combine_two) {
    arrive_and_wait(numbers.data(), [&] {
      const auto of = [&](int shard) {
        return std::span(static_cast<double*>(barrier_->numbers[shard]), numbers.size());
      };
      barrier_->results.assign(of(0).begin(), of(0).end());
      for (int shard = 1; shard < barrier_->shards->count(); ++shard)
        std::ranges::transform(barrier_->results, of(shard), barrier_->results.begin(),
                               combine_two);
    });
    std::ranges::copy(barrier_->results, numbers.begin());
  }

  std::shared_ptr<ShardBarrier> barrier_;
  int shard_;
};

}  // namespace

CpuShards make_cpu_shards(std::shared_ptr<const Shards> shards, LockStep& steps) {
  const int count = shards->count();
  auto barrier = std::make_shared<ShardBarrier>(ShardBarrier{shards, steps, {}, {}});
  barrier->numbers.resize(count);
  CpuShards made;
  for (int shard = 0; shard < count; ++shard) {
    made.halos.push_back(std::make_unique<CpuHalo>(barrier, shard));
    made.backends.push_back(make_cpu_shard_backend(shards->all[shard].on, *made.halos.back()));
  }
  return made;
}

}  // namespace burnish
