// Fields of the window that a user types into.

#include <fstream>

#include <gmock/gmock.h>

#include "tests/system/window_fixture.h"

namespace burnish {
namespace {

constexpr int kBetaFieldX = 238;
constexpr int kReplaceX = 432, kReplaceY = 443;

class FieldWindow : public WindowTest {
 protected:
  void type_beta(const std::string& text) {
    click(kBetaFieldX, kBetaY);
    screen_->type(text);
    screen_->key({"Return"});
  }
  double beta() { return connection_->state("desk")->settings.beta; }
};

TEST_F(FieldWindow, TakesADecimalCommaAndRefusesWhatIsNotANumber) {
  open_window();
  type_beta("0,35");
  EXPECT_TRUE(eventually([this] { return beta() == 0.35; })) << beta();
  const size_t before = history().size();
  type_beta("5 mm");
  save_screen("refused.png");
  type_beta("25");  // is clamped
  EXPECT_TRUE(eventually([this] { return beta() == 10; })) << beta();
  EXPECT_EQ(history().size(), before + 1);
}

TEST_F(FieldWindow, TakesTheTextWhenTheUserGoesToTheSurface) {
  open_window();
  click_on("Brush/Strength as a number");
  screen_->type("0,25");
  screen_->drag(kPictureX - 60, kPictureY, kPictureX + 60, kPictureY);
  newest_of(1);
  screen_->close_window();
  EXPECT_EQ(window_->wait(kPatience), 0) << window_->output();
  std::ifstream file(server_->folder / "window.toml");
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  EXPECT_THAT(text, testing::HasSubstr("brush_strength = 0.25"));
}

// The field has the keyboard, and all of its text is chosen.
TEST_F(FieldWindow, ACheckpointThatIsSetAgainIsRestoredAtItsLastPlace) {
  for (int i = 0; i < 2; ++i)
    ASSERT_EQ(server_->burnish({"checkpoint", "desk", "draft"}).exit_code, 0);
  open_window();
  places_->wait_for("History/Restore 2");
  EXPECT_FALSE(places_->find("History/Restore 1").has_value());
}

TEST_F(FieldWindow, EnterExportsAndAFileIsReplacedOnlyAfterAQuestion) {
  open_window();
  const auto file = server_->folder / "out.ply";
  const auto is_asked = [this] {  // the panel covers the surface
    return eventually([this] { return !is_surface(screen_->capture()); });
  };
  const auto export_there = [&] {
    screen_->key({"Control_L", "e"});
    ASSERT_TRUE(is_asked()) << window_->output();
    screen_->type(file.string());
    screen_->key({"Return"});
  };
  export_there();
  EXPECT_TRUE(eventually([&] { return std::filesystem::exists(file); })) << window_->output();
  EXPECT_TRUE(shows_surface());
  for (const char* record : {"out-record.json", "out-record.html"})
    EXPECT_TRUE(eventually([&] { return std::filesystem::exists(server_->folder / record); }));
  server_->folder.write("out.ply", "mine");
  export_there();
  screen_->key({"Return"});
  EXPECT_TRUE(is_asked());
  save_screen("replace.png");
  EXPECT_EQ(std::filesystem::file_size(file), 4u);
  click(kReplaceX, kReplaceY);
  EXPECT_TRUE(shows_surface());
  EXPECT_TRUE(eventually([&] { return std::filesystem::file_size(file) > 1000; }));
}

}  // namespace
}  // namespace burnish
