// Built with CUDA only; needs no device.

#include "server/solver/cuda/mesh/packed_restriction.h"

#include <utility>

#include <gtest/gtest.h>

#include "server/solver/cuda/device/packed.h"

namespace burnish::cuda {
namespace {

using Row = std::vector<std::pair<int32_t, float>>;

// Returns a row for each list of weights, of fine corners 10, 11, 12, ...
DepthTransfer transfer_of(const std::vector<std::vector<float>>& weights) {
  DepthTransfer transfer;
  transfer.restriction_start = {0};
  for (const std::vector<float>& row : weights) {
    for (const float weight : row) {
      transfer.restriction_corner.push_back(
          static_cast<int32_t>(10 + transfer.restriction_corner.size()));
      transfer.restriction_weight.push_back(weight);
    }
    transfer.restriction_start.push_back(static_cast<int64_t>(transfer.restriction_corner.size()));
  }
  return transfer;
}

// Powers of two, a row of a shared corner, a row that is too long, powers of two again.
DepthTransfer a_transfer() {
  return transfer_of({{1, 0.5f, 0.25f, 0.125f},
                      {1, 0.3f},
                      std::vector<float>(kRestrictionMax + 1, 0.5f),
                      std::vector<float>(kRestrictionMax, 0.125f)});
}

TEST(PackedRestriction, ListsRowsThatDoNotFit) {
  const PackedRestriction packed = pack_restriction(a_transfer());
  EXPECT_EQ(packed.listed, (std::vector<int32_t>{1, 2}));
  EXPECT_EQ(packed.listed_start, (std::vector<int32_t>{0, 2, 3 + kRestrictionMax}));
  EXPECT_EQ(packed.start, (std::vector<int64_t>{0, 4, 4, 4, 4 + kRestrictionMax}));
}

// Kernels take an empty packed row for a listed one, and write no number there.
TEST(PackedRestriction, ListsEmptyRowsBesideOthers) {
  EXPECT_EQ(pack_restriction(transfer_of({{1}, {}, {0.3f}, {}})).listed,
            (std::vector<int32_t>{1, 2, 3}));
  EXPECT_TRUE(pack_restriction(transfer_of({{1}, {}})).listed.empty());
}

TEST(PackedRestriction, HasEveryEntryOfEveryRow) {
  const DepthTransfer transfer = a_transfer();
  const PackedRestriction packed = pack_restriction(transfer);
  std::vector<Row> expected(4), found(4);
  for (int row = 0; row < 4; ++row) {
    for (auto k = transfer.restriction_start[row]; k < transfer.restriction_start[row + 1]; ++k)
      expected[row].emplace_back(transfer.restriction_corner[k], transfer.restriction_weight[k]);
    for (auto k = packed.start[row]; k < packed.start[row + 1]; ++k)
      found[row].emplace_back(corner_of(packed.packed[k]), weight_of(packed.packed[k]));
  }
  for (size_t n = 0; n < packed.listed.size(); ++n)
    for (auto k = packed.listed_start[n]; k < packed.listed_start[n + 1]; ++k)
      found[packed.listed[n]].emplace_back(packed.listed_from[k], packed.listed_weight[k]);
  EXPECT_EQ(found, expected);
}

}  // namespace
}  // namespace burnish::cuda
