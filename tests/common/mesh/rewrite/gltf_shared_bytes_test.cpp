#include "common/mesh/rewrite/gltf/gltf_shared_bytes.h"

#include "tests/common/gltf/glb_file.h"

namespace burnish {
namespace {

using testing::ElementsAre;

std::vector<bool> shared_accessors(const GlbFile& file) {
  const std::string glb = file.glb();
  const auto document = open_gltf({reinterpret_cast<const uint8_t*>(glb.data()), glb.size()});
  EXPECT_TRUE(document.is_ok()) << document.status().message();
  return find_shared_accessors(*document);
}

TEST(GltfSharedBytes, AccessorsWithViewsOfTheirOwnShareNone) {
  GlbFile file;
  file.add_floats("VEC3", 2, {0, 0, 0, 1, 1, 1});
  file.add_indices({0, 1, 0});
  EXPECT_THAT(shared_accessors(file), ElementsAre(false, false));
}

TEST(GltfSharedBytes, InterleavedAccessorsShareNoneUnlessTheirElementsOverlap) {
  GlbFile file;
  const size_t view = file.add_view(std::string(48, 'a'), {{"byteStride", 24}});
  file.add_accessor(view, "VEC3", 5126, 2);
  file.add_accessor(view, "VEC3", 5126, 2, {{"byteOffset", 12}});
  EXPECT_THAT(shared_accessors(file), ElementsAre(false, false));
  file.add_accessor(view, "VEC2", 5126, 2, {{"byteOffset", 16}});
  EXPECT_THAT(shared_accessors(file), ElementsAre(false, true, true));
}

TEST(GltfSharedBytes, BlocksOfOneViewShareNoneUnlessTheyOverlap) {
  GlbFile file;
  const size_t view = file.add_view(std::string(96, 'a'), {{"byteStride", 16}});
  file.add_accessor(view, "VEC3", 5126, 3);
  file.add_accessor(view, "VEC3", 5126, 3, {{"byteOffset", 48}});
  EXPECT_THAT(shared_accessors(file), ElementsAre(false, false));
  file.add_accessor(view, "VEC3", 5126, 2, {{"byteOffset", 32}});
  EXPECT_THAT(shared_accessors(file), ElementsAre(true, true, true));
}

TEST(GltfSharedBytes, ViewsThatOverlapShareTheirBytes) {
  GlbFile file;
  file.add_floats("VEC3", 2, {0, 0, 0, 1, 1, 1});
  file.json["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", 20}, {"byteLength", 4}});
  EXPECT_THAT(shared_accessors(file), ElementsAre(true));
  file.json["bufferViews"][1]["byteOffset"] = 24;
  EXPECT_THAT(shared_accessors(file), ElementsAre(false));
}

}  // namespace
}  // namespace burnish
