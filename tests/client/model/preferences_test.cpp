#include "client/model/settings/preferences.h"

#include <fstream>

#include <gtest/gtest.h>

#include "tests/common/temporary_folder.h"

namespace burnish {
namespace {

TEST(Preferences, WhatIsWrittenIsReadAgain) {
  const TemporaryFolder folder;
  const auto path = folder / "below/window.toml";
  Preferences written;
  written.user = "ada";
  remember_server(written.servers, {.address = "host:1", .token = "secret"});
  remember_server(written.servers,
                  {"lab:2", true, "/lab.pem", "bert", "kept", /*keeps_token=*/true});
  written.brush_beta = 2.5;
  written.window_width = 1600;
  written.lighting = {.kind = LightKind::kRaking, .specular = 0.5};
  written.keys["undo"] = "Ctrl+U";
  written.native_dialogs = false;
  written.light_theme = true;
  written.pen_pressure = false;
  for (const char* each : {"/a", "/b", "/a"}) remember_folder(written, each);
  remember(written.recent, {"", "desk", "abc"});
  remember(written.recent, {"host:1", "wall", "def", "id", "stone", 1'700'000'000, 5'000'000'000});
  ASSERT_TRUE(write_preferences(written, path).is_ok());
  const auto read = read_preferences(path);
  ASSERT_TRUE(read.is_ok()) << read.status().message();
  EXPECT_EQ(read->user, "ada");
  EXPECT_EQ(read->servers, (std::vector<KnownServer>{written.servers[0], {.address = "host:1"}}));
  EXPECT_EQ(read->brush_beta, 2.5);
  EXPECT_EQ(read->window_width, 1600);
  EXPECT_EQ(read->lighting, written.lighting);
  EXPECT_EQ(read->keys.at("undo"), "Ctrl+U");
  EXPECT_FALSE(read->native_dialogs);
  EXPECT_TRUE(read->light_theme);
  EXPECT_FALSE(read->pen_pressure);
  EXPECT_EQ(read->folders, (std::vector<std::filesystem::path>{"/a", "/b"}));
  EXPECT_EQ(read->recent, written.recent);
  EXPECT_EQ(read->recent[0].session, "wall");
}

TEST(Preferences, AreForTheirUserAlone) {
  const TemporaryFolder folder;
  const auto path = folder / "config/window.toml";
  ASSERT_TRUE(write_preferences({}, path).is_ok());
  EXPECT_EQ(std::filesystem::status(path.parent_path()).permissions(),
            std::filesystem::perms(0700));
  std::filesystem::permissions(path, std::filesystem::perms(0644));  // as older versions left it
  ASSERT_TRUE(write_preferences({}, path).is_ok());
  EXPECT_EQ(std::filesystem::status(path).permissions(), std::filesystem::perms(0600));
}

TEST(Preferences, WithoutAFileThereAreDefaults) {
  const TemporaryFolder folder;
  const auto read = read_preferences(folder / "none.toml");
  ASSERT_TRUE(read.is_ok());
  EXPECT_EQ(read->window_width, 1280);
}

TEST(Preferences, ADamagedFileIsNamedWithItsLine) {
  const TemporaryFolder folder;
  const auto path = folder / "window.toml";
  std::ofstream(path) << "user = 'ada'\nscale = = 2\n";
  const auto read = read_preferences(path);
  ASSERT_FALSE(read.is_ok());
  EXPECT_NE(read.status().message().find("window.toml:2"), std::string::npos)
      << read.status().message();
}

TEST(Preferences, ValuesOutsideTheirLimitsAreBroughtInside) {
  const TemporaryFolder folder;
  const auto path = folder / "window.toml";
  std::ofstream(path) << "brush_strength = 7.0\nscale = -3.0\n";
  const auto read = read_preferences(path);
  ASSERT_TRUE(read.is_ok());
  EXPECT_EQ(read->brush_strength, 1);
  EXPECT_EQ(read->scale, 0);
}

TEST(Preferences, AFileInTheFolderWhereWeAreNeedsNoPath) {
  const TemporaryFolder folder;
  const auto before = std::filesystem::current_path();
  std::filesystem::current_path(folder / "");
  const Status written = write_preferences({.user = "ada"}, "window.toml");
  std::filesystem::current_path(before);
  ASSERT_TRUE(written.is_ok()) << written.message();
  EXPECT_EQ(read_preferences(folder / "window.toml")->user, "ada");
}

}  // namespace
}  // namespace burnish
