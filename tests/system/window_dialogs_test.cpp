// Dialogs and lists of the start page in a real window.

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <utility>

#include <gmock/gmock.h>

#include "tests/system/window_fixture.h"

namespace burnish {
namespace {

using testing::HasSubstr;
using testing::Not;

constexpr int kCardX = 580, kCardY = 180;
constexpr int kOtherServerX = 390, kOtherServerY = 291;

class DialogWindow : public WindowTest {
 protected:
  void SetUp() override {
    WindowTest::SetUp();
    configure("native_dialogs = false\n");
  }
  void configure(const std::string& text) { server_->folder.write("window.toml", text); }

  void open_start_page() {
    start_window({"--scale", "1"});
    ASSERT_TRUE(eventually([this] { return is_drawn(); })) << window_->output();
  }
  // The large button has the accent's colour.
  bool is_drawn() {
    const Image image = screen_->capture();
    return image.pixel(150, 120)[2] > image.pixel(150, 120)[0] + 60;
  }
  std::string preferences() const {
    std::ifstream file(server_->folder / "window.toml");
    return {std::istreambuf_iterator<char>(file), {}};
  }
  void end_window() {
    screen_->close_window();
    EXPECT_EQ(window_->wait(kPatience), 0) << window_->output();
  }
};

TEST_F(DialogWindow, TheOwnFilePanelOpensWhatIsTyped) {
  write_sphere(server_->folder, 3);
  open_start_page();
  screen_->key({"Control_L", "o"});
  screen_->type((server_->folder / "").string());
  screen_->key({"Return"});
  save_screen("open.png");
  screen_->type("sph");
  save_screen("open-filtered.png");
  screen_->key({"Return"});
  ASSERT_TRUE(shows_session()) << window_->output();
  EXPECT_THAT(screen_->title(), HasSubstr("sphere3"));
  end_window();
  EXPECT_THAT(preferences(), HasSubstr("folders"));
}

TEST_F(DialogWindow, AScanIsOpenedFromASessionToo) {
  write_sphere(server_->folder, 3);
  open_window();
  screen_->key({"Control_L", "o"});
  screen_->type((server_->folder / "sphere3.ply").string());
  screen_->key({"Return"});
  EXPECT_TRUE(eventually([&] { return screen_->title().find("sphere3 ·") == 0; }))
      << screen_->title();
}

TEST_F(DialogWindow, TheDesktopsFileDialogIsAskedWhereThereIsOne) {
  const auto scan = write_sphere(server_->folder, 3);
  const auto program = server_->folder.write("zenity", "#!/bin/sh\necho '" + scan + "'\n");
  std::filesystem::permissions(program, std::filesystem::perms(0700));
  configure("");
  const std::string path = std::getenv("PATH");
  setenv("PATH", ((server_->folder / "").string() + ":" + path).c_str(), 1);
  open_start_page();
  setenv("PATH", path.c_str(), 1);
  screen_->key({"Control_L", "o"});
  ASSERT_TRUE(shows_session()) << window_->output();
  EXPECT_THAT(screen_->title(), HasSubstr("sphere3"));
}

TEST_F(DialogWindow, ARecentSessionHasACardWithItsPictureThatOpensIt) {
  open_window();
  end_window();
  const auto pictures = std::filesystem::directory_iterator(server_->folder / "pictures");
  EXPECT_EQ(std::distance(begin(pictures), end(pictures)), 1);
  open_start_page();
  // The picture is clay before a light background.
  EXPECT_TRUE(eventually([&] {
    const Image image = screen_->capture();
    return image.pixel(kCardX, kCardY)[0] > image.pixel(kCardX, kCardY)[2] + 5;
  }));
  save_screen("cards.png");
  click(kCardX, kCardY);
  EXPECT_TRUE(shows_session()) << window_->output();
}

TEST_F(DialogWindow, AServerThatWasConnectedToIsRememberedWithoutItsToken) {
  constexpr int kFieldX = 780, kPortY = 250, kProblemY = 274;
  open_start_page();
  click(kOtherServerX, kOtherServerY);
  screen_->type("localhost");
  const auto enter_port = [&](const std::string& port) {
    click(kFieldX, kPortY);  // chooses all of the field's text
    screen_->type(port);
    screen_->key({"Return"});
  };
  enter_port("70000");
  EXPECT_TRUE(eventually([&] {  // red words below the field
    const Image image = screen_->capture();
    int red = 0;
    for (int x = 650; x < 830; ++x)
      red += image.pixel(x, kProblemY)[0] > image.pixel(x, kProblemY)[2] + 80;
    return red > 5;
  }));
  save_screen("connection-wrong.png");
  const std::string port = server_->address.substr(server_->address.rfind(':') + 1);
  enter_port(port);
  EXPECT_TRUE(eventually([&] { return !places_->find("Connect/Host"); }));  // it is connected
  end_window();
  EXPECT_THAT(preferences(), HasSubstr("localhost:" + port));
  EXPECT_THAT(preferences(), Not(HasSubstr("70000")));
  EXPECT_THAT(preferences(), Not(HasSubstr("token")));
}

TEST_F(DialogWindow, ASessionIsRenamedInTheList) {
  constexpr int kRenameX = 1048, kRowY = 284;
  open_start_page();
  click(kRenameX, kRowY);
  screen_->type("table");
  save_screen("rename.png");
  screen_->key({"Return"});
  EXPECT_TRUE(eventually([this] { return connection_->list_sessions()->at(0).name == "table"; }));
}

TEST_F(DialogWindow, PanelsAreLightAndLargeIfThePreferencesSaySo) {
  configure("light_theme = true\nscale = 2.0\n");
  start_window({"--session", "desk"});
  middle_x_ = 920;
  ASSERT_TRUE(shows_session()) << window_->output();
  settle();
  save_screen("light.png");
  const Image image = screen_->capture();
  EXPECT_GT(image.pixel(3, 400)[0], 200);    // the left panel's border
  EXPECT_GT(image.pixel(500, 400)[0], 200);  // which is 560 pixels wide
}

TEST_F(DialogWindow, EscapeClosesTheListThatIsOpenAndThenItsDialog) {
  open_start_page();
  click_on("Menu/File");
  click_on("Menu/Preferences");
  click_on("Preferences/Size");
  places_->wait_for("Preferences/200 %");
  screen_->key({"Escape"});
  EXPECT_TRUE(eventually([this] { return !places_->find("Preferences/200 %"); }));
  EXPECT_TRUE(places_->find("Area/Preferences").has_value());
  screen_->key({"Escape"});
  EXPECT_TRUE(eventually([this] { return !places_->find("Area/Preferences"); }));
}

TEST_F(DialogWindow, NamesInChineseAreDrawn) {
  if (std::system("fc-list ':charset=5934' | grep -q .") != 0)
    GTEST_SKIP() << "no font here has Chinese letters: deploy/setup installs one";
  ASSERT_TRUE(connection_->rename_scan("blob", "头").is_ok());
  open_start_page();
  const auto name = [this] {
    const Image image = screen_->capture();
    std::vector<uint8_t> pixels;
    for (int y = 198; y < 214; ++y)  // the row of the scan
      pixels.insert(pixels.end(), image.pixel(500, y), image.pixel(530, y));
    return pixels;
  };
  // The row is empty until the list has come. Two boxes would be equal.
  const auto has_two_colours = [](const std::vector<uint8_t>& pixels) {
    constexpr int kChannels = 3;  // in one colour each pixel equals the next
    return !std::equal(pixels.begin() + kChannels, pixels.end(), pixels.begin());
  };
  std::vector<uint8_t> head, bone;
  EXPECT_TRUE(
      eventually([&] { return head == std::exchange(head, name()) && has_two_colours(head); }));
  save_screen("letters.png");
  end_window();
  ASSERT_TRUE(connection_->rename_scan("头", "骨").is_ok());
  open_start_page();
  EXPECT_TRUE(eventually([&] {
    return bone == std::exchange(bone, name()) && has_two_colours(bone) && bone != head;
  }));
  end_window();
  open_window();  // its letters are loaded while it is shown
  EXPECT_THAT(screen_->title(), HasSubstr("骨"));
}

}  // namespace
}  // namespace burnish
