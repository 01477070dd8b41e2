#include "client/tools/own_presets.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/common/temporary_folder.h"

namespace burnish {
namespace {

using testing::HasSubstr;

Preset own(const std::string& name, double beta) {
  return {.name = name,
          .description = "",
          .beta = beta,
          .curve = *TransferCurve::create({{-5, 20}, {5, 200}})};
}

TEST(OwnPresets, AreThereAgainAndReplacedByName) {
  const TemporaryFolder folder;
  const auto path = folder / "config/presets";
  EXPECT_TRUE(read_own_presets(path)->empty());
  ASSERT_TRUE(save_own_preset(path, own("faint lines", 2)).is_ok());
  ASSERT_TRUE(save_own_preset(path, own("back of the stone", 0.5)).is_ok());
  ASSERT_TRUE(save_own_preset(path, own("faint lines", 2.25)).is_ok());
  const auto presets = *read_own_presets(path);
  ASSERT_EQ(presets.size(), 2u);
  EXPECT_EQ(presets[0].name, "back of the stone");
  EXPECT_EQ(presets[1].name, "faint lines");
  EXPECT_EQ(presets[1].beta, 2.25);
  EXPECT_EQ(presets[1].curve, own("", 1).curve);
}

TEST(OwnPresets, KeepBandsForScansOfAnySize) {
  const TemporaryFolder folder;
  const ScanLengths scan{10, 0.1};
  const PresetFilter values{1, TransferCurve(50), {{{0.8, 0}, {4, 2.5}}}};
  ASSERT_TRUE(save_own_preset(folder / "presets", own_preset("faint lines", values, scan)).is_ok());
  const Preset read = read_own_presets(folder / "presets")->at(0);
  EXPECT_EQ(read.name, "faint lines");
  EXPECT_EQ(strength_of(read, values, scan), 1);
  const PresetFilter larger = filter_of(read, 1, {20, 0.3});
  ASSERT_EQ(larger.equaliser.bands.size(), 2u);
  EXPECT_NEAR(larger.equaliser.bands[1].size, 8, 1e-9);
  EXPECT_EQ(larger.equaliser.bands[1].gain, 2.5);
}

TEST(OwnPresets, AreDeletedByName) {
  const TemporaryFolder folder;
  const auto path = folder / "presets";
  ASSERT_TRUE(save_own_preset(path, own("faint lines", 2)).is_ok());
  ASSERT_TRUE(save_own_preset(path, own("back of the stone", 0.5)).is_ok());
  ASSERT_TRUE(delete_own_preset(path, "faint lines").is_ok());
  const auto presets = *read_own_presets(path);
  ASSERT_EQ(presets.size(), 1u);
  EXPECT_EQ(presets[0].name, "back of the stone");
  const Status again = delete_own_preset(path, "faint lines");
  EXPECT_EQ(again.code(), StatusCode::kNotFound);
  EXPECT_THAT(again.message(), HasSubstr("faint lines"));
}

TEST(OwnPresets, HaveNamesThatScriptsCanSay) {
  const TemporaryFolder folder;
  const auto refusal = [&](const std::string& name) {
    return save_own_preset(folder / "presets", own(name, 2)).message();
  };
  EXPECT_THAT(refusal("Soften"), HasSubstr("built in"));
  EXPECT_THAT(refusal("stone 3"), HasSubstr("number"));
  EXPECT_THAT(refusal("stone #3"), HasSubstr("#"));
  EXPECT_THAT(refusal("bands=3"), HasSubstr("bands="));
  EXPECT_THAT(refusal(""), HasSubstr("empty"));
}

TEST(OwnPresets, ABadLineIsNamed) {
  const TemporaryFolder folder;
  folder.write("presets", "2 0:50 good\n11 0:50 bad\n");
  const auto presets = read_own_presets(folder / "presets");
  EXPECT_THAT(presets.status().message(), HasSubstr("presets:2"));
  EXPECT_THAT(presets.status().message(), HasSubstr("11"));
}

}  // namespace
}  // namespace burnish
