// Nothing is cut: panels and dialogs at several sizes, in both themes.

#include <gmock/gmock.h>

#include "tests/system/window_fixture.h"

namespace burnish {
namespace {

using testing::IsEmpty;

struct Fit {
  std::string name;
  ImageSize size;
  std::string scale;
  bool is_light;
};

class FittingWindow : public WindowTest, public testing::WithParamInterface<Fit> {
 protected:
  void SetUp() override {
    WindowTest::SetUp();
    if (IsSkipped()) return;
    const Fit& fit = GetParam();
    window_size_ = fit.size;
    screen_ = std::make_unique<XDisplay>(fit.size);
    server_->folder.write("window.toml", std::string("native_dialogs = false\nlight_theme = ") +
                                             (fit.is_light ? "true\n" : "false\n"));
  }

  void open(const std::string& what) {
    start_window({what, "desk", "--scale", GetParam().scale});
    places_->wait_for("Area/Left column");
    ASSERT_TRUE(eventually([this] { return screen_->title().find("·") != std::string::npos; }));
  }

  std::string right_column() const {
    return places_->find("Area/Right column") ? "Right column" : "Left column";
  }

  // Returns what is wider than its panel, or beyond the screen.
  std::vector<std::string> misfits() const {
    static const std::string kContent = "/content";
    const auto places = places_->all();
    std::vector<std::string> names;
    for (const auto& [name, box] : places) {
      if (!name.starts_with("Area/")) continue;
      const auto content = places.find(name + kContent);
      if (content == places.end()) continue;
      const bool is_cut = content->second.width > box.width;
      const bool scrolls = name == "Area/Entries" || name == "Area/Lists";  // with its column
      const bool is_beyond = box.x < 0 || box.x + box.width > window_size_.width ||
                             (!scrolls && (box.y < 0 || box.y + box.height > window_size_.height));
      if (is_cut || is_beyond)
        names.push_back(name + " " + std::to_string(box.width) + " of " +
                        std::to_string(content->second.width) + " at " + std::to_string(box.x) +
                        "," + std::to_string(box.y));
    }
    return names;
  }

  void check(const std::string& shown) {
    std::this_thread::sleep_for(std::chrono::milliseconds(400));  // hints and pictures come
    save_screen("fit-" + GetParam().name + "-" + shown + ".png");
    EXPECT_THAT(misfits(), IsEmpty()) << shown;
  }
};

TEST_P(FittingWindow, HasRoomForAllPanels) {
  ASSERT_EQ(server_->burnish({"edit", "desk", "--band", "0.2:0.5", "--band", "0.5:2"}).exit_code,
            0);
  open("--session");
  check("session");
  scroll_to("Limits", "Left column");
  for (const char* const panel : {"Equaliser", "Palette"}) {
    scroll_to(panel, "Left column");
    click_on(panel);
  }
  scroll_to("Palette/Add", "Left column");
  check("left");
  for (const auto& [panel, last] :
       {std::pair("Light", "Light/As at first"), {"Camera", "Camera/Orthographic"}}) {
    scroll_to(panel, right_column());
    click_on(panel);
    scroll_to(last, right_column());
    check(panel);
  }
}

TEST_P(FittingWindow, HasRoomForMenusAndDialogs) {
  open("--session");
  for (const char* const menu : {"File", "Edit", "View", "Help"}) {
    click_on(std::string("Menu/") + menu);
    check(std::string("menu-") + menu);
    screen_->key({"Escape"});
  }
  if (!places_->find("Filter/Presets")) scroll_to("Filter/Presets", "Left column");
  click_on("Filter/Presets");
  check("presets");
  screen_->key({"Escape"});
  screen_->key({"Shift_L", "question"});
  places_->wait_for("Area/Keys");
  check("keys");
  screen_->key({"Escape"});
  screen_->key({"l"});
  places_->wait_for("Area/Messages");
  check("messages");
  screen_->key({"Escape"});
  screen_->key({"Control_L", "e"});
  places_->wait_for("Area/Export");
  check("export");
  screen_->key({"Escape"});
  click_on("Menu/File");
  click_on("Menu/Preferences");
  places_->wait_for("Area/Preferences");
  check("preferences");
  screen_->key({"Escape"});
  screen_->key({"Control_L", "o"});
  places_->wait_for("Area/Files");
  check("files");
}

TEST_P(FittingWindow, HasRoomForTheStartPage) {
  open("--session");
  click_on("Menu/File");
  click_on("Menu/Close session");
  places_->wait_for("Area/Start page");
  check("start");
  click_on("Start/Another server");
  places_->wait_for("Area/Connect");
  check("connect");
}

INSTANTIATE_TEST_SUITE_P(Sizes, FittingWindow,
                         testing::Values(Fit{"usual", {1280, 720}, "1", false},
                                         Fit{"small", {1024, 700}, "1", true},
                                         Fit{"large", {1280, 720}, "2", false}),
                         [](const auto& fit) { return fit.param.name; });

}  // namespace
}  // namespace burnish
