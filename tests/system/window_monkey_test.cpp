// A user who clicks, drags and types at random.

#include <cstdlib>
#include <random>

#include <gmock/gmock.h>

#include "common/mesh/io/mesh_io.h"
#include "tests/system/window_fixture.h"

namespace burnish {
namespace {

using testing::HasSubstr;
using testing::Not;

class MonkeyWindow : public WindowTest {
 protected:
  static constexpr int kMenuBar = 30;

  void SetUp() override {
    WindowTest::SetUp();
    if (IsSkipped()) return;
    server_->folder.write("window.toml", "native_dialogs = false\n");
  }

  int below(int end) { return static_cast<int>(random_() % static_cast<unsigned>(end)); }
  int x() { return below(kScreen.width); }
  int y() { return kMenuBar + below(kScreen.height - kMenuBar); }

  void act() {
    const int kind = below(20);
    if (kind < 8) return click_somewhere();
    if (kind < 13) return drag_somewhere();
    if (kind < 17) return press_a_key();
    if (kind < 19) return turn_the_wheel();
    screen_->resize_window({700 + below(kScreen.width - 700), 450 + below(kScreen.height - 450)});
  }

  // The menu File is left out: it has Quit and Close session.
  static bool is_allowed(const std::string& widget) {
    for (const char* const other : {"Area/", "Menu/File", "Export/Export"})
      if (widget.starts_with(other)) return false;
    return true;
  }

  void click_somewhere() {
    std::vector<Box> boxes;
    for (const auto& [name, box] : places_->all())
      if (is_allowed(name)) boxes.push_back(box);
    if (boxes.empty()) return;
    const Box& box = boxes[static_cast<size_t>(below(static_cast<int>(boxes.size())))];
    screen_->move(box.x + below(std::max(1, box.width)), box.y + below(std::max(1, box.height)));
    screen_->press(1);
    screen_->release(1);
  }

  void drag_somewhere() {
    const int button = 1 + below(3);
    const bool has_control = below(4) == 0;
    if (has_control) screen_->hold("Control_L");
    screen_->move(x(), y());
    screen_->press(button);
    screen_->move(x(), y());
    screen_->release(button);
    if (has_control) screen_->let_go("Control_L");
  }

  void press_a_key() {
    static const std::vector<std::vector<std::string>> kKeys = {{"s"},
                                                                {"w"},
                                                                {"m"},
                                                                {"n"},
                                                                {"c"},
                                                                {"b"},
                                                                {"l"},
                                                                {"f"},
                                                                {"1"},
                                                                {"3"},
                                                                {"5"},
                                                                {"7"},
                                                                {"Home"},
                                                                {"Tab"},
                                                                {"Escape"},
                                                                {"End"},
                                                                {"space"},
                                                                {"Delete"},
                                                                {"bracketleft"},
                                                                {"bracketright"},
                                                                {"period"},
                                                                {"minus"},
                                                                {"Shift_L", "f"},
                                                                {"Shift_L", "question"},
                                                                {"Control_L", "z"},
                                                                {"Control_L", "y"},
                                                                {"Control_L", "o"},
                                                                {"Control_L", "e"},
                                                                {"Control_L", "a"}};
    screen_->key(kKeys[static_cast<size_t>(below(static_cast<int>(kKeys.size())))]);
  }

  void turn_the_wheel() {
    constexpr int kWheelUp = 4;
    screen_->move(x(), y());
    for (int i = below(3); i >= 0; --i) {
      const int button = kWheelUp + below(2);
      screen_->press(button);
      screen_->release(button);
    }
  }

  static unsigned seed() {
    const char* const wanted = std::getenv("BURNISH_MONKEY_SEED");
    return wanted ? static_cast<unsigned>(std::atoi(wanted)) : 1;
  }
  std::mt19937 random_{seed()};
};

TEST_F(MonkeyWindow, LivesThroughThreeHundredRandomActsAndItsSessionExports) {
  open_window();
  for (int i = 0; i < 300 && !has_ended(); ++i) act();
  save_screen("monkey.png");
  const auto ended = window_->wait(std::chrono::milliseconds(0));
  ASSERT_FALSE(ended.has_value()) << *ended << window_->output();
  for (int i = 0; i < 4; ++i) screen_->key({"Escape"});
  screen_->close_window();
  const auto code = window_->wait(kPatience);
  save_screen("monkey-closed.png");
  EXPECT_EQ(code, 0);
  EXPECT_EQ(window_->output(), "");
  EXPECT_THAT(server_->process->output(), Not(HasSubstr("error")));
  const auto file = server_->folder / "out.ply";
  const CommandOutcome exported = server_->burnish({"export", "desk", file.string()});
  EXPECT_EQ(exported.exit_code, 0) << exported.output;
  const auto mesh = read_mesh(file), scan = read_mesh(server_->folder / "blob.ply");
  ASSERT_TRUE(mesh.is_ok() && scan.is_ok());
  EXPECT_EQ(mesh->triangles.size(), scan->triangles.size());
  EXPECT_FALSE(history().empty());
}

}  // namespace
}  // namespace burnish
