#include "common/packing/narrow_values.h"

#include <gtest/gtest.h>

namespace burnish {
namespace {

TEST(NarrowValues, ValuesOfTwoAndOfFourBytesComeBack) {
  for (const int32_t extreme : {32767, -32768, 32768, -32769, 1 << 30}) {
    const std::vector<int32_t> values = {3, extreme, -5};
    std::vector<int32_t> read(values.size());
    const NarrowValues kept(values);
    kept.read(read);
    EXPECT_EQ(read, values);
    EXPECT_EQ(kept.size(), values.size());
  }
}

TEST(NarrowValues, TwoBytesAValueWhereTheyFit) {
  std::vector<int32_t> values(100, -32768);
  const uint64_t narrow = NarrowValues(values).byte_count();
  values[0] = -32769;
  EXPECT_EQ(NarrowValues(values).byte_count() - narrow, 200u);
}

}  // namespace
}  // namespace burnish
