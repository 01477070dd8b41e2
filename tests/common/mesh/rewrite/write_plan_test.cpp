#include "common/mesh/rewrite/write_plan.h"

#include <gmock/gmock.h>

#include "tests/common/archive/packing.h"
#include "tests/common/gltf/glb_file.h"
#include "tests/common/temporary_folder.h"

namespace burnish {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

constexpr MeshFormat kFormats[] = {MeshFormat::kPly, MeshFormat::kObj, MeshFormat::kStl,
                                   MeshFormat::kOff, MeshFormat::kGlb, MeshFormat::kGltf};

TEST(WritePlan, AScanIsWrittenInItsOwnFormatAndAsAnArchive) {
  for (const MeshFormat format : kFormats) {
    EXPECT_EQ(find_way(format, format, format, "").value(), WriteWay::kRewrite);
    EXPECT_EQ(find_way(format, format, MeshFormat::kZip, "").value(), WriteWay::kPack);
    EXPECT_EQ(find_way(MeshFormat::kZip, format, format, "").value(), WriteWay::kUnpack);
    EXPECT_EQ(find_way(MeshFormat::kZip, format, MeshFormat::kZip, "").value(), WriteWay::kRewrite);
  }
}

TEST(WritePlan, OffAndGltfAreForScansThatCameInThem) {
  for (const MeshFormat file : kFormats)
    for (const MeshFormat to : kFormats) {
      if (file == to) continue;
      const bool is_refused = to == MeshFormat::kOff || to == MeshFormat::kGltf;
      for (const MeshFormat outer : {file, MeshFormat::kZip}) {
        const auto way = find_way(outer, file, to, "scan");
        if (is_refused) {
          EXPECT_EQ(way.status().code(), StatusCode::kInvalidArgument);
        } else {
          EXPECT_EQ(way.value(), WriteWay::kConvert);
        }
      }
    }
  EXPECT_EQ(
      find_way(MeshFormat::kZip, MeshFormat::kObj, MeshFormat::kOff, "scan").status().message(),
      "scan has a .obj file: only a scan from a .off file is written as .off; use .ply, .obj, "
      ".stl, .glb or .zip");
}

/// A glTF file whose data lies beside it.
std::string spread_gltf(const std::string& buffer) {
  const GlbFile file = square_glb();
  TestJson json = file.json;
  json["buffers"] = {{{"byteLength", file.bin.size()}, {"uri", buffer}}};
  return json.dump();
}

TEST(WritePlan, TheDataBesideAGltfIsNamed) {
  const TemporaryFolder folder;
  const std::string gltf = spread_gltf("my%20data.bin");
  const OriginalFile alone = {folder.write("a.gltf", gltf), MeshFormat::kGltf, "a"};
  const auto archive = as_string(packed({{"in/a.gltf", gltf}, {"in/my data.bin", "x"}}));
  const OriginalFile in_archive = {folder.write("a.zip", archive), MeshFormat::kZip, "a"};
  for (const OriginalFile& original : {alone, in_archive}) {
    const auto plan = plan_to_write(original, MeshFormat::kGltf);
    ASSERT_TRUE(plan.is_ok()) << plan.status().message();
    EXPECT_THAT(plan->buffers, ElementsAre("my data.bin"));
    EXPECT_THAT(check_one_file(*plan).message(), HasSubstr("'my data.bin'"));
    for (const MeshFormat to : {MeshFormat::kPly, MeshFormat::kGlb, MeshFormat::kZip})
      EXPECT_TRUE(check_one_file(plan_to_write(original, to).value()).is_ok());
  }
  const OriginalFile whole = {folder.write("b.gltf", square_glb().gltf()), MeshFormat::kGltf, "b"};
  EXPECT_TRUE(check_one_file(plan_to_write(whole, MeshFormat::kGltf).value()).is_ok());
}

}  // namespace
}  // namespace burnish
