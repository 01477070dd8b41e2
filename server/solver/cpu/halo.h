#pragma once

#include <span>

#include <Eigen/Core>

namespace burnish::cpu {

/// Asks the other shards of a scan (solver/multi). All shards make the same calls in the
/// same order. A depth's vectors have own corners first, then ghosts.
class Halo {
 public:
  virtual ~Halo() = default;
  virtual int border() const = 0;  ///< deeper depths are split

  /// Brings the owners' numbers to the ghosts.
  virtual void refresh(int depth, std::span<Eigen::Array4f> vector) = 0;
  virtual void refresh(int depth, std::span<float> vector) = 0;
  /// Adds the ghosts' numbers to the owners', shard by shard, and brings the sums to the ghosts.
  virtual void add_up(int depth, std::span<Eigen::Array4f> vector) = 0;
  /// Brings the numbers of the border depth's cells and ties to the first shard.
  virtual void collect(double* numbers) = 0;

  /// Makes each number its sum over the shards, in their order.
  virtual void sum(std::span<double> numbers) = 0;
  virtual void keep_largest(double& number) = 0;
};

}  // namespace burnish::cpu
