#include "common/gltf/meshopt_attributes.h"

#include <gtest/gtest.h>

#include "tests/common/gltf/meshopt_packing.h"

namespace burnish {
namespace {

std::span<const uint8_t> bytes_in(const std::string& text) {
  return {reinterpret_cast<const uint8_t*>(text.data()), text.size()};
}

/// Elements that change slowly, with a jump now and then, and zeros at the end of each.
std::string some_elements(size_t count, size_t stride) {
  std::string elements;
  for (size_t i = 0; i < count; ++i)
    for (size_t b = 0; b < stride; ++b)
      elements += static_cast<char>(
          b + 4 >= stride && stride > 4 ? 0 : i * (b % 3) + (i % 9 == 0 ? 77 : 0));
  return elements;
}

bool unpacks(const std::string& packed, size_t stride, const std::string& elements) {
  std::vector<uint8_t> result(elements.size());
  return unpack_meshopt_attributes(bytes_in(packed), stride, result) &&
         std::string(result.begin(), result.end()) == elements;
}

TEST(MeshoptAttributes, EachWayOfPackingGivesTheElements) {
  for (const std::vector<uint8_t>& modes : std::vector<std::vector<uint8_t>>{
           {0}, {1}, {2}, {0x52}, {0, 1, 2}, {0xf2, 0, 1, 2, 0x12}, std::vector<uint8_t>(64, 1)})
    for (const size_t count : {1, 16, 17, 256, 600}) {
      const std::string elements = some_elements(count, 4 * modes.size());
      EXPECT_TRUE(unpacks(MeshoptPacking(modes).packed(elements), 4 * modes.size(), elements))
          << count << " elements of " << modes.size() << " channels";
    }
}

TEST(MeshoptAttributes, DamagedBytesAreNotRead) {
  const std::string elements = some_elements(40, 8);
  const std::string packed = MeshoptPacking({0, 1}).packed(elements);
  EXPECT_TRUE(is_meshopt_version_1(bytes_in(packed)));
  for (size_t bytes = 0; bytes < packed.size(); ++bytes)
    EXPECT_FALSE(unpacks(packed.substr(0, bytes), 8, elements)) << bytes;
  EXPECT_FALSE(unpacks(packed.substr(0, 1) + "x" + packed.substr(1), 8, elements));
  std::string other = packed;
  for (const char mode : {'\3', '\x10'}) {
    other.back() = mode;
    EXPECT_FALSE(unpacks(other, 8, elements));
  }
}

TEST(MeshoptAttributes, ColoursComeFromLumaAndChroma) {
  // Grey of 100, and red: Y 63, Co 127, Cg -64, of 8 bits; alpha has 7 bits below a mark.
  std::vector<uint8_t> colours = {100, 0, 0, 0xff, 63, 127, static_cast<uint8_t>(-64), 0x80};
  apply_meshopt_colour_filter(colours, 4);
  EXPECT_EQ(colours, (std::vector<uint8_t>{100, 100, 100, 255, 254, 0, 0, 0}));
}

}  // namespace
}  // namespace burnish
