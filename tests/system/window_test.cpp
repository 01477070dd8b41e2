#include <csignal>
#include <filesystem>
#include <optional>

#include <gmock/gmock.h>

#include "client/scene/png_reader.h"
#include "common/base/text_lines.h"
#include "tests/client/scene/png_description.h"
#include "tests/system/link.h"
#include "tests/system/window_fixture.h"

namespace burnish {
namespace {

constexpr int kPlotX = 200, kPlotY = 290;
constexpr int kQuestionY = 345, kButtonsY = 394, kWaitX = 530, kDiscardX = 630;
constexpr int kColourX = 1160, kColourY = 71, kBetaColourY = 119;

/// A window whose server may go away.
class LeftWindow : public WindowTest {
 protected:
  // Returns whether the window asks about unsaved edits. The question lies over the middle; its
  // panel is darker than the picture.
  bool window_asks() {
    const Image image = screen_->capture();
    int dark = 0;
    for (int x = 500; x < 780; ++x) {
      const uint8_t* rgb = image.pixel(x, kQuestionY);
      dark += rgb[0] < 40 && rgb[1] < 42 && rgb[2] < 48;
    }
    return dark > 200;
  }

  // Paints a stroke that cannot be saved, because the server is gone.
  void paint_without_a_server() {
    open_window();
    server_->listen = server_->address;
    server_->kill();
    screen_->drag(kPictureX - 60, kPictureY, kPictureX + 60, kPictureY);
  }
};

TEST_F(WindowTest, AStrokeASliderACurvePointAndUndoChangeTheSessionAndThePicture) {
  open_window();
  const Image untouched = settle();

  screen_->drag(kPictureX - 60, kPictureY, kPictureX + 60, kPictureY);
  const HistoryEntry stroke = newest_of(1);
  EXPECT_EQ(stroke.kind, EditKind::kStroke);
  EXPECT_EQ(stroke.author, "ada");
  EXPECT_TRUE(until_it_differs(untouched, 0.3));
  const Image painted = settle();

  screen_->drag(kBetaMiddleX, kBetaY, kBetaLeftX, kBetaY);
  EXPECT_EQ(newest_of(2).kind, EditKind::kGradientScale);
  EXPECT_TRUE(eventually([&] { return connection_->state("desk")->settings.beta < 0.3; }));
  EXPECT_TRUE(until_it_differs(painted, 1));
  const Image smoothed = settle();

  screen_->drag(kPlotX, kPlotY, kPlotX, kPlotY - 40);
  EXPECT_EQ(newest_of(3).kind, EditKind::kTransferCurve);
  EXPECT_TRUE(
      eventually([&] { return connection_->state("desk")->settings.curve.points().size() == 2; }));
  EXPECT_TRUE(until_it_differs(smoothed, 0.1));

  screen_->move(kPictureX, kPictureY);
  for (size_t left : {2, 1, 0}) {
    screen_->key({"Control_L", "z"});
    ASSERT_TRUE(eventually([&] { return entries_on() == left; }));
  }
  EXPECT_TRUE(until_it_is(untouched, 0.05));
}

TEST_F(WindowTest, TheMiddleButtonTurnsAndHomeComesBackWithoutAnEdit) {
  open_window();
  const Image front = settle();
  screen_->drag(kPictureX, kPictureY, kPictureX + 200, kPictureY, 2);
  EXPECT_TRUE(until_it_differs(front, 1));
  screen_->drag(kPictureX, kPictureY, kPictureX - 200, kPictureY, 2);
  EXPECT_TRUE(until_it_is(front, 1));
  EXPECT_TRUE(history().empty());
}

TEST_F(WindowTest, TheWheelNeverLosesTheScan) {
  open_window();
  const auto turn = [this](int button, int clicks) {
    screen_->move(kPictureX, kPictureY);
    for (int i = 0; i < clicks; ++i) {
      screen_->press(button);
      screen_->release(button);
    }
  };
  constexpr int kUp = 4, kDown = 5;
  turn(kUp, 80);
  EXPECT_TRUE(shows_surface()) << window_->output();
  screen_->key({"Home"});
  turn(kDown, 150);
  EXPECT_TRUE(eventually([this] {
    const Image image = screen_->capture();
    int clay = 0;  // pixels of the small scan around the pointer
    for (int y = kPictureY - 20; y < kPictureY + 20; ++y)
      for (int x = kPictureX - 20; x < kPictureX + 20; ++x)
        clay += image.pixel(x, y)[0] > image.pixel(x, y)[2] + 5;
    return clay > 20;
  })) << window_->output();
}

TEST_F(WindowTest, CtrlQQuits) {
  open_window();
  screen_->move(kPictureX, kPictureY);
  screen_->key({"Control_L", "q"});
  EXPECT_TRUE(eventually([this] { return has_ended(); })) << window_->output();
}

// Pure white: nothing else in the picture is.
int ring_pixels(const Image& image) {
  int count = 0;
  for (size_t i = 0; i < image.rgb.size(); i += 3)
    count += image.rgb[i] == 255 && image.rgb[i + 1] == 255 && image.rgb[i + 2] == 255;
  return count;
}

/// A window that saves its pictures in a folder of the test.
class PictureWindow : public WindowTest {
 protected:
  void open_in_folder() {
    const auto before = std::filesystem::current_path();
    std::filesystem::create_directory(folder());
    std::filesystem::current_path(folder());  // of the window too
    open_window();
    std::filesystem::current_path(before);
  }

  std::optional<std::filesystem::path> saved_picture() {
    screen_->key({"F12"});
    std::optional<std::filesystem::path> found;
    eventually([&] {
      for (const auto& file : std::filesystem::directory_iterator(folder()))
        if (file.path().extension() == ".png") found = file.path();
      return found.has_value();
    });
    return found;
  }

 private:
  std::filesystem::path folder() const { return server_->folder / "pictures"; }
};

TEST_F(PictureWindow, ASavedPictureHasNoRing) {
  open_in_folder();
  settle();
  screen_->move(kPictureX, kPictureY);
  EXPECT_TRUE(eventually([&] { return ring_pixels(screen_->capture()) > 50; }));
  const auto file = saved_picture();
  ASSERT_TRUE(file.has_value());
  const auto saved = read_png(*file, kImageSidePixelsMax);
  ASSERT_TRUE(saved.is_ok()) << saved.status().message();
  EXPECT_EQ(ring_pixels(*saved), 0);
  EXPECT_EQ(png_description(read_text_file(*file).value()), "");
  EXPECT_TRUE(eventually([&] { return ring_pixels(screen_->capture()) > 50; }));
}

TEST_F(PictureWindow, ASavedPictureHasTheScaleBar) {
  open_in_folder();
  settle();
  const auto file = saved_picture();
  ASSERT_TRUE(file.has_value());
  const auto saved = read_png(*file, kImageSidePixelsMax);
  ASSERT_TRUE(saved.is_ok()) << saved.status().message();
  const auto [width, height] = saved->size;
  int ink = 0;
  for (int x = width - 200; x < width; ++x)
    for (int y = height - 40; y < height; ++y) ink += saved->pixel(x, y)[0] == 230;
  EXPECT_GT(ink, 150);
}

TEST_F(PictureWindow, ASavedPictureSaysThatItIsSimplified) {
  more_words_ = {"--triangles", "1000"};
  open_in_folder();
  const auto file = saved_picture();
  ASSERT_TRUE(file.has_value());
  EXPECT_THAT(png_description(read_text_file(*file).value()), testing::HasSubstr("simplified, "));
}

// At 200 % there is one column, and the history is near its end.
TEST_F(WindowTest, InASmallWindowAllPanelsAreInOneColumnThatScrolls) {
  middle_x_ = 920;
  open_window("10", "2");
  scroll_to("History/Fork", "Left column");
  save_screen("column.png");
  click_on("History/Fork");
  EXPECT_TRUE(eventually([&] { return connection_->list_sessions()->size() == 2; }));
}

TEST_F(WindowTest, HidesAtOnceThoughACallWaitsForAStalledLink) {
  Link link(server_->address, {.delay = std::chrono::milliseconds(1)});
  server_->address = link.address();
  open_window("600");
  link.stall(true);
  screen_->drag(kColourX, kColourY, kColourX, kColourY);          // a list of views
  screen_->drag(kColourX, kBetaColourY, kColourX, kBetaColourY);  // the client fetches its colours
  window_->signal(SIGTERM);
  EXPECT_TRUE(eventually([&] { return !screen_->has_window(); }));
  EXPECT_FALSE(window_->wait(std::chrono::milliseconds(0)).has_value()) << window_->output();
}

TEST_F(WindowTest, SurvivesAServerThatDiesMidStrokeAndAWindowOfNoSize) {
  open_window();
  screen_->move(kPictureX - 60, kPictureY);
  screen_->press(1);
  for (int step = 0; step < 10; ++step) {
    screen_->move(kPictureX - 60 + 6 * step, kPictureY);
    if (step == 5) server_->kill();
  }
  screen_->release(1);
  screen_->resize_window({1, 1});
  screen_->resize_window({700, 400});
  screen_->resize_window(kScreen);
  // Grey: the picture may be out of date.
  EXPECT_TRUE(eventually([&] {
    const Tone tone = tone_of(screen_->capture());
    return tone.brightness > 60 && std::abs(tone.warmth) < 2;
  }));
  EXPECT_FALSE(window_->wait(std::chrono::milliseconds(0)).has_value()) << window_->output();
  window_->signal(SIGTERM);
  EXPECT_EQ(window_->wait(kPatience), 1);
  EXPECT_NE(window_->output().find("1 edit is not saved and will be lost"), std::string::npos)
      << window_->output();
}

TEST_F(LeftWindow, AsksBeforeItClosesOverUnsavedEditsAndWaitsForThemIfAsked) {
  paint_without_a_server();
  screen_->close_window();
  ASSERT_TRUE(eventually([&] { return window_asks(); })) << window_->output();
  screen_->key({"Escape"});
  EXPECT_TRUE(eventually([&] { return !window_asks(); }));
  EXPECT_FALSE(window_->wait(std::chrono::milliseconds(0)).has_value()) << window_->output();

  screen_->close_window();
  ASSERT_TRUE(eventually([&] { return window_asks(); }));
  screen_->drag(kWaitX, kButtonsY, kWaitX, kButtonsY);
  server_->start();
  EXPECT_EQ(window_->wait(kPatience), 0) << window_->output();
  connection_ = std::make_unique<Connection>(
      std::move(Connection::open(server_->address, kPatience)).value());
  EXPECT_EQ(history().size(), 1u);
}

TEST_F(LeftWindow, ClosesOverUnsavedEditsThatAreDiscarded) {
  paint_without_a_server();
  screen_->close_window();
  ASSERT_TRUE(eventually([&] { return window_asks(); })) << window_->output();
  screen_->drag(kDiscardX, kButtonsY, kDiscardX, kButtonsY);
  EXPECT_EQ(window_->wait(kPatience), 0) << window_->output();
  server_->start();
  connection_ = std::make_unique<Connection>(
      std::move(Connection::open(server_->address, kPatience)).value());
  EXPECT_TRUE(history().empty());
}

}  // namespace
}  // namespace burnish
