// In builds with CUDA; no device is needed.

#include "server/solver/cuda/packed_restriction.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "server/solver/cuda/packed.h"

namespace burnish::cuda {
namespace {

// Two coarse corners, of which the first gathers more fine ones than are packed.
DepthTransfer a_transfer() {
  DepthTransfer transfer;
  for (int32_t i = 0; i < kRestrictionMax + 2; ++i) {
    transfer.restriction_corner.push_back(i);
    transfer.restriction_weight.push_back(0.25f);
  }
  transfer.restriction_weight[3] = 0.3f;
  for (const float weight : {1.0f, 0.5f, 0.25f, 0.125f, 0.0625f, 2.0f}) {
    transfer.restriction_corner.push_back(100);
    transfer.restriction_weight.push_back(weight);
  }
  const auto all = static_cast<int64_t>(transfer.restriction_corner.size());
  transfer.restriction_start = {0, all - 6, all};
  return transfer;
}

TEST(PackedRestriction, HasEveryEntryOnceInItsRow) {
  const DepthTransfer transfer = a_transfer();
  const PackedRestriction packed = pack_restriction(transfer);
  for (int row = 0; row < 2; ++row) {
    std::vector<std::pair<int32_t, float>> expected, found;
    for (auto k = transfer.restriction_start[row]; k < transfer.restriction_start[row + 1]; ++k)
      expected.emplace_back(transfer.restriction_corner[k], transfer.restriction_weight[k]);
    for (auto k = packed.start[row]; k < packed.start[row + 1]; ++k)
      found.emplace_back(corner_of(packed.packed[k]), weight_of(packed.packed[k]));
    for (auto k = packed.rest_start[row]; k < packed.rest_start[row + 1]; ++k)
      found.emplace_back(packed.rest_corner[k], packed.rest_weight[k]);
    std::ranges::sort(expected);
    std::ranges::sort(found);
    EXPECT_EQ(found, expected) << "row " << row;
  }
}

TEST(PackedRestriction, LeavesWhatDoesNotFit) {
  const PackedRestriction packed = pack_restriction(a_transfer());
  EXPECT_EQ(packed.start, (std::vector<int64_t>{0, kRestrictionMax, kRestrictionMax + 4}));
  EXPECT_EQ(packed.rest_weight, (std::vector<float>{0.3f, 0.25f, 0.0625f, 2.0f}));
}

TEST(PackedRestriction, OfWholeWeightsHasNoRest) {
  DepthTransfer transfer;
  transfer.restriction_start = {0, 2};
  transfer.restriction_corner = {0, 1};
  transfer.restriction_weight = {1, 0.125f};
  EXPECT_TRUE(pack_restriction(transfer).rest_start.empty());
}

}  // namespace
}  // namespace burnish::cuda
