// Draws the README's pictures: uses the real window by mouse and keys on its own screen.
// window_pictures OUT [SCALE] [light]   SCALE 2: as on a screen with twice the resolution

#include <cstdio>
#include <functional>
#include <thread>
#include <unistd.h>

#include "client/connection/connection.h"
#include "client/connection/session_link.h"
#include "client/scene/camera.h"
#include "client/scene/png_writer.h"
#include "common/base/check.h"
#include "common/generate/generate.h"
#include "common/mesh/mesh_io.h"
#include "tests/system/fetched_pages.h"
#include "tests/system/server_process.h"
#include "tests/system/sheet.h"
#include "tests/system/x_display.h"

namespace burnish {
namespace {

using std::chrono::milliseconds;

constexpr ImageSize kWindow{1280, 720};  // at scale 1, as all places below
constexpr Box kPicture{280, 22, 762, 698};
constexpr int kWheelUp = 4;
constexpr Box kMiddle{400, 260, 340, 300};  // part of the picture without figures and toasts

/// A window on a server with scans and people, and its user.
class Studio {
 public:
  Studio(std::filesystem::path out, int scale, bool is_light)
      : out_(std::move(out)), scale_(scale) {
    server_.folder.write("window.toml", std::string("native_dialogs = false\nlight_theme = ") +
                                            (is_light ? "true\n" : "false\n"));
    BURNISH_CHECK(chdir((server_.folder / "").c_str()) == 0, "no folder");  // paths are typed
    for (const auto& [kind, name, vertices] :
         {std::tuple{"tablet", "tablet", 60'000}, {"blob", "figurine", 20'000}}) {
      write_scan(kind, name, vertices);
      done({"import", std::string(name) + ".ply", "--depth", "7"});
    }
    write_scan("blob", "column", 400'000);
    done({"open", "figurine", "--depth", "7", "--session", "figurine", "--user", "bert"});
    done({"open", "tablet", "--depth", "7", "--session", "fresco", "--user", "ada"});
    connection_.set_user("bert");
    setenv("DISPLAY", screen_.name().c_str(), 1);
    window_ = server_.start_burnish({"window", "--session", "fresco", "--user", "ada", "--scale",
                                     std::to_string(scale), "--width", width(), "--height",
                                     height(), "--config", "window.toml"});
    screen_.focus_window();
    wait_until([this] { return is_clay(crop(kMiddle)); });
    settle();
  }

  void move(int x, int y) {
    screen_.move(scale_ * x, scale_ * y);
    pause(300);
  }
  void press(int x, int y, int button = 1) {
    move(x, y);
    screen_.press(button);
    pause(200);
  }
  void release(int button = 1) {
    screen_.release(button);
    pause(300);
  }
  void click(int x, int y, int button = 1) {
    press(x, y, button);
    release(button);
  }
  void drag(int from_x, int from_y, int to_x, int to_y) {
    screen_.drag(scale_ * from_x, scale_ * from_y, scale_ * to_x, scale_ * to_y);
  }
  void key(const std::vector<std::string>& names) {
    screen_.key(names);
    pause(300);
  }
  void type(const std::string& text) {
    for (const char letter : text) {
      if (letter == '.') {
        screen_.key({"period"});
      } else {
        screen_.key({letter == ' ' ? "space" : std::string(1, letter)});
      }
    }
    pause(300);
  }

  Image crop(const Box& box) { return cut(screen_.capture(), scaled(box, scale_)); }
  /// Takes a picture at half size, for pictures without text.
  Image small(const Box& box) { return halved(crop(box)); }
  void save(const std::string& name, const Image& image) const {
    const Status written = write_png(image, out_ / (name + ".png"));
    BURNISH_CHECK(written.is_ok(), written.message());
    std::printf("%s\n", name.c_str());
  }
  void save(const std::string& name, const Box& box) { save(name, crop(box)); }

  /// Shows or hides the figures over the picture.
  void toggle_figures() {
    click(101, 12);
    click(120, 94);
    rest();
  }
  /// Moves the pointer to a place over nothing.
  void rest() {
    move(20, 700);
    settle();
  }

  /// Waits until the surface is at rest.
  void settle() {
    Image last = crop(kMiddle);
    int still = 0;
    wait_until([&] {
      pause(200);
      Image now = crop(kMiddle);
      still = now.rgb == last.rgb ? still + 1 : 0;
      last = std::move(now);
      return still >= 6;
    });
  }

  /// Adds another user, who works at the right of the inscription.
  void let_bert_in() {
    const SessionInfo session = connection_.list_sessions().value().at(1);
    const FetchedPages fetched = fetch_all_pages(connection_, session.scan_id);
    bert_ = std::make_unique<SessionLink>(connection_,
                                          fetched.live_options("fresco", session.key.depth));
    std::vector<Vec3d> vertices;
    for (const auto& page : fetched.level(0))
      for (const Vec3i& position : page->positions)
        vertices.push_back(fetched.head.grid.to_file(position));
    Eigen::AlignedBox3d box;
    for (const Vec3d& vertex : vertices) box.extend(vertex);
    const Eigen::Matrix3d axes = camera_axes({.azimuth_degrees = 25, .elevation_degrees = 20});
    const double size = box.diagonal().norm();
    const auto badness = [&](const Vec3d& vertex) {  // beside the middle, and in front
      const Vec3d seen = axes * (vertex - box.center()) / size;
      return (seen.head<2>() - Eigen::Vector2d(0.15, -0.05)).norm() - 0.1 * seen.z();
    };
    const auto best =
        std::min_element(vertices.begin(), vertices.end(),
                         [&](const Vec3d& a, const Vec3d& b) { return badness(a) < badness(b); });
    bert_->move_brush(BrushRing{*best, 0.05 * size});
    pause(1500);
  }

  static void pause(int ms) { std::this_thread::sleep_for(milliseconds(ms)); }

 private:
  static bool is_clay(const Image& image) {  // warm; panels and background are cold
    long warmth = 0;
    for (size_t i = 0; i < image.rgb.size(); i += 3) warmth += image.rgb[i] - image.rgb[i + 2];
    return warmth > 3 * static_cast<long>(image.rgb.size() / 3);
  }
  static void wait_until(const std::function<bool()>& holds) {
    const auto end = std::chrono::steady_clock::now() + kPatience;
    while (!holds()) {
      BURNISH_CHECK(std::chrono::steady_clock::now() < end, "the window does not come to rest");
      pause(50);
    }
  }
  void write_scan(const std::string& kind, const std::string& name, uint64_t vertices) const {
    const auto mesh = generate_scan({.kind = kind, .vertices = vertices});
    const Status written =
        mesh.is_ok() ? write_mesh(*mesh, server_.folder / (name + ".ply")) : mesh.status();
    BURNISH_CHECK(written.is_ok(), written.message());
  }
  void done(std::vector<std::string> words) {
    const CommandOutcome outcome = server_.burnish(std::move(words));
    BURNISH_CHECK(outcome.exit_code == 0, outcome.output);
  }
  std::string width() const { return std::to_string(scale_ * kWindow.width); }
  std::string height() const { return std::to_string(scale_ * kWindow.height); }

  const std::filesystem::path out_;
  const int scale_;
  ServerProcess server_;
  Connection connection_ = Connection::open(server_.address, kPatience).value();
  XDisplay screen_{{scale_ * kWindow.width, scale_* kWindow.height}};
  std::unique_ptr<SessionLink> bert_;
  std::unique_ptr<Process> window_;
};

/// Smooths everything, then brings the inscription out again. Draws one tile for each step.
void draw_an_edit(Studio& studio) {
  studio.toggle_figures();
  Studio::pause(7000);  // toasts disappear
  std::vector<Image> steps = {studio.small(kPicture)};
  studio.drag(107, 119, 15, 119);   // β to 0
  studio.drag(129, 167, 103, 167);  // α down: broader forms
  studio.rest();
  steps.push_back(studio.small(kPicture));

  studio.click(227, 421);           // the brush sharpens
  studio.drag(136, 517, 152, 517);  // and gets larger
  studio.press(560, 425);
  for (int x = 560; x <= 690; x += 10) studio.move(x, 425);
  studio.settle();
  steps.push_back(studio.small(kPicture));
  studio.save("brush", {0, 382, 280, 260});
  studio.release();
  studio.rest();
  steps.push_back(studio.small(kPicture));
  studio.save("edit", in_rows(steps, 2));
  studio.toggle_figures();
  studio.save("figures", {768, 28, 268, 204});
  studio.move(830, 400);
  Studio::pause(1000);
  studio.save("window", {0, 0, 1280, 720});
}

void draw_filter(Studio& studio) {
  constexpr Box kFilter{0, 22, 280, 340};
  const Image closed = studio.crop(kFilter);
  studio.click(130, 71);
  Studio::pause(1000);
  studio.save("filter", in_rows({closed, studio.crop(kFilter)}, 2));
  studio.click(130, 71);
}

void draw_curve(Studio& studio) {
  studio.press(205, 285);
  studio.move(205, 260);
  studio.move(205, 240);
  Studio::pause(1000);
  studio.save("curve", {0, 193, 280, 182});
  studio.release();
  studio.settle();
}

void draw_history(Studio& studio) {
  studio.click(1075, 327);  // switches off the curve's entry
  studio.settle();
  studio.click(1120, 490);
  studio.type("before the stamp");
  studio.click(1105, 518);
  studio.rest();
  studio.save("history", {1042, 250, 238, 288});
}

void draw_views(Studio& studio) {
  std::vector<Image> tiles;
  studio.toggle_figures();
  studio.save("view", {1042, 32, 238, 196});
  for (int i = 0; i < 4; ++i) {  // clay, β, curvature, displacement
    if (i > 0) {
      studio.click(1160, 71);
      studio.click(1120, 99 + 20 * i);
      studio.rest();
    }
    tiles.push_back(studio.small(kPicture));
  }
  studio.click(1160, 71);
  studio.click(1120, 99);
  studio.rest();
  studio.key({"s"});
  studio.rest();
  tiles.push_back(studio.small(kPicture));
  studio.key({"s"});
  for (int i = 0; i < 14; ++i) studio.click(600, 425, kWheelUp);
  studio.key({"w"});
  studio.rest();
  tiles.push_back(studio.small(kPicture));
  studio.save("views", in_rows(tiles, 3));
  studio.key({"w"});
  studio.key({"Home"});
  studio.toggle_figures();
}

void draw_people(Studio& studio) {
  studio.let_bert_in();
  studio.move(600, 425);
  studio.save("people", {460, 290, 820, 330});
}

void draw_dialogs(Studio& studio) {
  studio.key({"Shift_L", "question"});
  Studio::pause(1000);
  studio.save("keys", {225, 178, 830, 364});
  studio.key({"Escape"});
  studio.key({"Control_L", "e"});
  studio.move(640, 600);
  Studio::pause(1000);
  studio.save("export", {345, 280, 590, 160});
  studio.click(382, 381);  // exact
  constexpr Box kToasts{280, 630, 520, 90};
  studio.click(420, 409);
  const Image exporting = studio.crop(kToasts);
  studio.rest();
  studio.save("exporting", in_rows({exporting, studio.crop(kToasts)}, 1));
  studio.key({"l"});
  Studio::pause(1000);
  studio.save("messages", {320, 195, 640, 330});
  studio.key({"Escape"});
}

void draw_start_page(Studio& studio) {
  studio.click(24, 12);   // File
  studio.click(60, 132);  // Close session
  Studio::pause(1500);
  studio.save("start", {0, 0, 1280, 720});
  studio.key({"Control_L", "o"});
  Studio::pause(1000);
  studio.save("open", {240, 110, 800, 500});
  studio.key({"Escape"});
  studio.click(390, 291);  // Another server
  Studio::pause(1000);
  studio.save("server", {300, 170, 680, 380});
  studio.key({"Escape"});
  studio.click(200, 225);
  studio.type("column.ply");
  studio.key({"Return"});
  Studio::pause(1500);
  studio.save("raw", {0, 0, 1280, 720});
}

void draw_all(const std::filesystem::path& out, int scale, bool is_light) {
  Studio studio(out, scale, is_light);
  draw_an_edit(studio);
  draw_filter(studio);
  draw_curve(studio);
  draw_history(studio);
  draw_views(studio);
  draw_people(studio);
  draw_dialogs(studio);
  draw_start_page(studio);
}

}  // namespace
}  // namespace burnish

int main(int count, char** words) {
  if (count < 2) {
    std::fprintf(stderr, "usage: window_pictures OUT [SCALE] [light]\n");
    return 2;
  }
  const int scale = count > 2 ? std::stoi(words[2]) : 1;
  const bool is_light = count > 3 && std::string(words[3]) == "light";
  burnish::draw_all(std::filesystem::absolute(words[1]), scale, is_light);
}
