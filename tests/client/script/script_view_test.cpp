#include "client/script/script_view.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace burnish {
namespace {

Status change(const std::string& text, Lighting& lighting) {
  const auto script = parse_script(text, "s");
  EXPECT_TRUE(script.is_ok()) << text;
  for (const ScriptLine& line : *script) {
    EXPECT_TRUE(is_light_command(line.command)) << line.command;
    RETURN_IF_ERROR(change_lighting(line, lighting));
  }
  return Status::ok();
}

TEST(ScriptView, TheLinesOfALightingGiveItBack) {
  const Lighting written{.kind = LightKind::kCavity,
                         .azimuth_degrees = -30,
                         .elevation_degrees = 5,
                         .specular = 0.25,
                         .occlusion = 0.5,
                         .radiance = 1.5,
                         .ridge = 0.75,
                         .valley = 2};
  std::string text;
  for (const std::string& line : script_lines(written)) text += line + "\n";
  Lighting read;
  ASSERT_TRUE(change(text, read).is_ok());
  EXPECT_EQ(read, written);
}

TEST(ScriptView, AWrongLightChangesNothingAndIsNamed) {
  Lighting lighting;
  EXPECT_THAT(change("light neon\n", lighting).message(), testing::HasSubstr("neon"));
  EXPECT_THAT(change("specular 7\n", lighting).message(), testing::HasSubstr("specular 7"));
  EXPECT_THAT(change("light_direction 0 100\n", lighting).message(), testing::HasSubstr("90"));
  EXPECT_FALSE(change("cavity 1 x\n", lighting).is_ok());
  EXPECT_EQ(lighting, Lighting{});
}

TEST(ScriptView, OtherCommandsAreNotOfTheLight) {
  EXPECT_FALSE(is_light_command("camera"));
  EXPECT_FALSE(is_light_command("mirror"));
}

}  // namespace
}  // namespace burnish
