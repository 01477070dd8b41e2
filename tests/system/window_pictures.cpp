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
#include "tests/system/places.h"
#include "tests/system/server_process.h"
#include "tests/system/sheet.h"
#include "tests/system/x_display.h"

namespace burnish {
namespace {

using std::chrono::milliseconds;

constexpr ImageSize kWindow{1280, 720};  // at scale 1
constexpr int kWheelUp = 4, kWheelDown = 5;
const char* const kLeft = "Left column";
const char* const kRight = "Right column";

/// A window on a server with scans and people, and its user. Places in the picture are at scale 1.
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
    write_painted("vase");
    done({"import", "vase.ply", "--depth", "7"});
    done({"open", "vase", "--depth", "7", "--session", "vase", "--user", "ada"});
    done({"open", "figurine", "--depth", "7", "--session", "figurine", "--user", "bert"});
    done({"open", "tablet", "--depth", "7", "--session", "fresco", "--user", "ada"});
    connection_.set_user("bert");
    setenv("DISPLAY", screen_.name().c_str(), 1);
    open_window("fresco");
  }

  /// Opens a session in a window of its own. The last window ends.
  void open_window(const std::string& session) {
    window_.reset();
    std::error_code ignored;
    std::filesystem::remove(server_.folder / "places", ignored);
    window_ = server_.start_burnish({"window", "--session", session, "--user", "ada", "--scale",
                                     std::to_string(scale_), "--width", width(), "--height",
                                     height(), "--config", "window.toml", "--places", "places"});
    screen_.focus_window();
    wait_until([this] { return is_clay(crop(middle())); });
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

  // Use widgets by their names.
  Box place_of(const std::string& widget) const { return places_.wait_for(widget); }
  void hover(const std::string& widget) {
    const Box box = place_of(widget);
    screen_.move(box.x + box.width / 2, box.y + box.height / 2);
    pause(300);
  }
  void click_on(const std::string& widget) {
    hover(widget);
    screen_.press(1);
    pause(200);
    screen_.release(1);
    pause(300);
  }
  /// Drags between two parts of a slider's width.
  void slide(const std::string& slider, double from, double to) {
    const Box box = place_of(slider);
    const int y = box.y + box.height / 2;
    const auto x_of = [&](double part) { return box.x + static_cast<int>(part * box.width); };
    screen_.drag(x_of(from), y, x_of(to), y);
  }
  /// Presses within a widget, in parts of its size, and moves. release() ends it.
  void press_in(const std::string& widget, const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
    const Box box = place_of(widget);
    const Eigen::Vector2d size(box.width, box.height);
    for (int step = 0; step <= 4; ++step) {
      const Eigen::Vector2d at = size.cwiseProduct(from + step / 4.0 * (to - from));
      screen_.move(box.x + static_cast<int>(at.x()), box.y + static_cast<int>(at.y()));
      pause(100);
      if (step == 0) screen_.press(1);
      if (step == 0) pause(200);
    }
  }
  /// Turns the wheel over a column until the whole section is seen.
  void scroll_to(const std::string& section, const char* column) {
    const Box box = place_of(std::string("Area/") + column);
    screen_.move(box.x + 4, box.y + box.height / 2);
    turn(kWheelUp, 60);
    for (int i = 0; i < 60 && !is_whole(section, box); ++i) turn(kWheelDown, 1);
    rest();
  }
  void open_section(const std::string& section, const char* column, const std::string& widget) {
    scroll_to(section, column);
    if (!places_.find(widget)) click_on(section);
    scroll_to(section, column);
  }

  Image crop(const Box& box) { return cut(screen_.capture(), within_screen(box)); }
  /// Takes a picture at half size, for pictures without text.
  Image small(const Box& box) { return halved(crop(box)); }
  void save(const std::string& name, const Image& image) const {
    const Status written = write_png(image, out_ / (name + ".png"));
    BURNISH_CHECK(written.is_ok(), written.message());
    std::printf("%s\n", name.c_str());
  }
  void save(const std::string& name, const Box& box) { save(name, crop(box)); }
  /// Saves a section, a dialog or another area with a margin around it.
  void save_area(const std::string& name, const std::string& area) {
    save(name, with_margin(place_of("Area/" + area), kMargin));
  }
  Box whole() const { return {0, 0, scale_ * kWindow.width, scale_ * kWindow.height}; }
  /// Returns the picture between both columns.
  Box picture() const {
    const Box left = place_of(std::string("Area/") + kLeft);
    const Box right = place_of(std::string("Area/") + kRight);
    const int from = left.x + left.width;
    return {from, left.y, right.x - from, left.height};
  }
  /// Returns a part of the picture without figures and toasts.
  Box middle() const { return scaled({400, 260, 340, 300}, scale_); }
  /// Returns the lower left of the picture, where messages appear.
  Box toasts() const {
    const Box box = picture();
    return {box.x, box.y + box.height - scale_ * 90, scale_ * 520, scale_ * 90};
  }
  Box with_margin(const Box& box, int margin) const {
    const int by = scale_ * margin;
    return {box.x - by, box.y - by, box.width + 2 * by, box.height + 2 * by};
  }

  /// Shows or hides the figures over the picture.
  void toggle_figures() {
    click_on("Menu/View");
    click_on("Menu/Figures");
    rest();
  }
  /// Moves the pointer to a place over nothing.
  void rest() {
    move(1030, 600);
    settle();
  }

  /// Waits until the surface is at rest.
  void settle() {
    Image last = crop(middle());
    int still = 0;
    wait_until([&] {
      pause(200);
      Image now = crop(middle());
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
  static constexpr int kMargin = 6;

  Box within_screen(const Box& box) const {
    const Box all = whole();
    const int left = std::max(box.x, 0), top = std::max(box.y, 0);
    return {left, top, std::min(box.x + box.width, all.width) - left,
            std::min(box.y + box.height, all.height) - top};
  }
  void turn(int button, int count) {
    for (int i = 0; i < count; ++i) {
      screen_.press(button);
      screen_.release(button);
    }
    pause(200);
  }
  bool is_whole(const std::string& section, const Box& column) const {
    const auto area = places_.find("Area/" + section);
    if (!area) return places_.find(section).has_value();  // it is closed
    return area->y + area->height <= column.y + column.height;
  }
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
  // A scan with colours: bands, and stains between them.
  void write_painted(const std::string& name) const {
    TriangleMesh mesh = generate_scan({.kind = "blob", .vertices = 60'000}).value();
    for (const Vec3d& vertex : mesh.vertices) {
      const bool is_band = std::sin(9 * vertex.y()) > 0.3;
      const bool is_stain = std::sin(17 * vertex.x()) * std::sin(19 * vertex.z()) > 0.5;
      mesh.colours.push_back(is_stain  ? Rgba8{120, 70, 50, 255}
                             : is_band ? Rgba8{215, 190, 130, 255}
                                       : Rgba8{165, 95, 60, 255});
    }
    BURNISH_CHECK(write_mesh(mesh, server_.folder / (name + ".ply")).is_ok(), "no room for scans");
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
  Places places_{server_.folder / "places"};
  std::unique_ptr<SessionLink> bert_;
  std::unique_ptr<Process> window_;
};

/// Smooths everything, then brings the inscription out again. Draws one tile for each step.
void draw_an_edit(Studio& studio) {
  studio.toggle_figures();
  Studio::pause(7000);  // toasts disappear
  std::vector<Image> steps = {studio.small(studio.picture())};
  studio.slide("Filter/Gradient scale β", 0.5, 0.01);
  studio.slide("Filter/Wavelength", 0.38, 0.5);  // broader forms
  studio.rest();
  steps.push_back(studio.small(studio.picture()));

  studio.click_on("Brush/Sharpen");
  studio.slide("Brush/Radius", 0.65, 0.75);
  studio.press(560, 425);
  for (int x = 560; x <= 690; x += 10) studio.move(x, 425);
  studio.settle();
  steps.push_back(studio.small(studio.picture()));
  studio.save_area("brush", "Brush");
  studio.release();
  studio.rest();
  steps.push_back(studio.small(studio.picture()));
  studio.save("edit", in_rows(steps, 2));
  studio.toggle_figures();
  studio.save_area("figures", "Figures over the picture");
  studio.move(830, 400);
  Studio::pause(1000);
  studio.save("window", studio.whole());
}

void draw_filter(Studio& studio) {
  Box filter = studio.with_margin(studio.place_of("Area/Filter"), 6);
  filter.height = studio.place_of("Area/Brush").y + filter.width / 3 - filter.y;  // of the list
  const Image closed = studio.crop(filter);
  studio.click_on("Filter/Presets");
  Studio::pause(1000);
  studio.save("filter", in_rows({closed, studio.crop(filter)}, 2));
  studio.key({"Escape"});
}

void draw_curve(Studio& studio) {
  studio.press_in("Transfer curve α(κ)/Plot", {0.8, 0.4}, {0.8, 0.15});
  Studio::pause(1000);
  studio.save_area("curve", "Transfer curve α(κ)");
  studio.release();
  studio.settle();
}

void draw_history(Studio& studio) {
  studio.scroll_to("History", kRight);
  studio.click_on("History/Entry 4");  // switches off the curve's entry
  studio.settle();
  studio.click_on("History/Name");
  studio.type("before the stamp");
  studio.click_on("History/Checkpoint");
  studio.rest();
  studio.save_area("history", "History");
}

void draw_limits(Studio& studio) {
  studio.scroll_to("Limits", kLeft);
  studio.slide("Limits/Largest move", 0.98, 0.6);
  studio.click_on("Limits/Protect");
  studio.press(470, 330);
  for (const auto& [x, y] : {std::pair(620, 320), {640, 400}, {480, 420}, {470, 330}})
    studio.move(x, y);
  studio.release();
  studio.rest();
  studio.save_area("limits", "Limits");
  studio.toggle_figures();
  studio.save("region", halved(studio.small(studio.picture())));
  studio.toggle_figures();
  for (int i = 0; i < 2; ++i) studio.key({"Control_L", "z"});
}

void draw_numbers(Studio& studio) {
  studio.scroll_to("Numbers", kRight);
  studio.click_on("Numbers/Unit");
  studio.type("mm");
  studio.key({"Return"});
  studio.click_on("Numbers/Measure");
  studio.click(560, 425);
  studio.click(690, 425);
  studio.scroll_to("Numbers", kRight);
  studio.save_area("numbers", "Numbers");
  studio.click_on("Numbers/Clear");
  studio.click_on("Numbers/Measure");
}

void draw_bands(Studio& studio) {
  studio.open_section("Equaliser", kLeft, "Equaliser/Make bands");
  studio.click_on("Equaliser/Make bands");
  studio.scroll_to("Equaliser", kLeft);
  studio.slide("Equaliser/Gain of band 1", 0.5, 0.2);
  studio.slide("Equaliser/Gain of band 3", 0.5, 0.75);
  studio.rest();
  studio.save_area("equaliser", "Equaliser");
  studio.open_section("Palette", kLeft, "Palette/Name");
  for (const char* const name : {"letters", "ground"}) {
    studio.click_on("Palette/Name");
    studio.type(name);
    studio.click_on("Palette/Add");
    studio.scroll_to("Palette", kLeft);
  }
  studio.save_area("palette", "Palette");
}

void draw_views(Studio& studio) {
  std::vector<Image> tiles;
  studio.toggle_figures();
  studio.scroll_to("View", kRight);
  studio.save_area("view", "View");
  const auto show = [&](const std::string& colour) {
    studio.click_on("View/Colour");
    studio.click_on("View/" + colour);
    studio.rest();
  };
  for (const char* const colour : {"Clay", "Gradient scale β", "Curvature", "Displacement"}) {
    show(colour);
    tiles.push_back(studio.small(studio.picture()));
  }
  show("Clay");
  studio.key({"s"});
  studio.rest();
  tiles.push_back(studio.small(studio.picture()));
  studio.key({"s"});
  for (int i = 0; i < 14; ++i) studio.click(600, 425, kWheelUp);
  studio.key({"w"});
  studio.rest();
  tiles.push_back(studio.small(studio.picture()));
  studio.save("views", in_rows(tiles, 3));
  studio.key({"w"});
  studio.key({"Home"});
  studio.toggle_figures();
}

void draw_people(Studio& studio) {
  studio.let_bert_in();
  studio.scroll_to("People", kRight);
  studio.move(600, 425);
  const Box people = studio.place_of("Area/People"), picture = studio.picture();
  const int left = picture.x + picture.width / 4, height = picture.height / 2;
  const int top = std::max(picture.y, people.y + people.height - height);
  studio.save("people", Box{left, top, people.x + people.width - left, height});
}

void draw_dialogs(Studio& studio) {
  studio.key({"Shift_L", "question"});
  studio.save_area("keys", "Keys");
  studio.key({"Escape"});
  studio.key({"Control_L", "e"});
  studio.move(640, 600);
  studio.save_area("export", "Export");
  studio.click_on("Export/Exact");
  studio.click_on("Export/Export");
  const Image exporting = studio.crop(studio.toasts());
  studio.rest();
  studio.save("exporting", in_rows({exporting, studio.crop(studio.toasts())}, 1));
  studio.key({"l"});
  studio.save_area("messages", "Messages");
  studio.key({"Escape"});
}

void draw_start_page(Studio& studio) {
  studio.click_on("Menu/File");
  studio.click_on("Menu/Close session");
  studio.place_of("Area/Start page");
  studio.move(20, 700);
  Studio::pause(1500);
  studio.save("start", studio.whole());
  studio.key({"Control_L", "o"});
  studio.save_area("open", "Files");
  studio.key({"Escape"});
  studio.click_on("Start/Another server");
  studio.save_area("server", "Connect");
  studio.key({"Escape"});
  studio.click_on("Start/Path");
  studio.type("column.ply");
  studio.key({"Return"});
  Studio::pause(1500);
  studio.save("raw", studio.whole());
}

void draw_colours(Studio& studio) {
  studio.open_window("vase");
  studio.toggle_figures();
  Studio::pause(7000);  // toasts disappear
  studio.open_section("Colours", kLeft, "Colours/Keep colours");
  const Image before = halved(studio.small(studio.picture()));
  studio.slide("Colours/Gradient scale of colours", 0.5, 0.01);
  studio.rest();
  studio.save_area("colours", "Colours");
  studio.save("evened", in_rows({before, halved(studio.small(studio.picture()))}, 2));
}

void draw_all(const std::filesystem::path& out, int scale, bool is_light) {
  Studio studio(out, scale, is_light);
  draw_an_edit(studio);
  draw_filter(studio);
  draw_curve(studio);
  draw_history(studio);
  draw_limits(studio);
  draw_numbers(studio);
  draw_views(studio);
  draw_people(studio);
  draw_bands(studio);
  draw_dialogs(studio);
  draw_start_page(studio);
  draw_colours(studio);
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
