#include "tests/system/picture_studio.h"

#include <unistd.h>

#include "client/scene/camera.h"
#include "client/scene/png_writer.h"
#include "common/base/check.h"
#include "common/mesh/io/mesh_io.h"
#include "tests/system/fetched_pages.h"

namespace burnish {

using std::chrono::milliseconds;

Studio::Studio(std::filesystem::path out, int scale, bool is_light)
    : out_(std::move(out)), scale_(scale) {
  server_.folder.write("window.toml", std::string("native_dialogs = false\nlight_theme = ") +
                                          (is_light ? "true\n" : "false\n"));
  BURNISH_CHECK(chdir((server_.folder / "").c_str()) == 0, "no folder");  // paths are typed
  write_scan({.kind = "tablet", .vertices = 60'000}, "tablet");
  write_scan({.kind = "blob", .vertices = 20'000}, "figurine");
  for (const char* const file : {"tablet.ply", "figurine.ply"})
    done({"import", file, "--depth", "7"});
  write_scan({.kind = "blob", .vertices = 400'000}, "column");
  write_painted("vase");
  done({"import", "vase.ply", "--depth", "7"});
  done({"open", "vase", "--depth", "7", "--session", "vase", "--user", "ada"});
  done({"open", "figurine", "--depth", "7", "--session", "figurine", "--user", "bert"});
  done({"open", "tablet", "--depth", "7", "--session", "fresco", "--user", "ada"});
  connection_.set_user("bert");
  setenv("DISPLAY", screen_.name().c_str(), 1);
  open_window("fresco");
}

void Studio::open_window(const std::string& session) {
  window_.reset();
  std::error_code ignored;
  std::filesystem::remove(server_.folder / "places", ignored);
  window_ = server_.start_burnish({"window", "--session", session, "--user", "ada", "--scale",
                                   std::to_string(scale_), "--width", width(), "--height", height(),
                                   "--config", "window.toml", "--places", "places"});
  screen_.focus_window();
  wait_until([this] { return is_clay(crop(middle())); });
  settle();
}

void Studio::open_scan(const GeneratedScan& scan, const std::string& name,
                       const std::vector<std::string>& changes) {
  write_scan(scan, name);
  done({"import", name + ".ply"});
  done({"open", name, "--session", name, "--user", "ada"});
  std::vector<std::string> edit = {"edit", name, "--user", "ada"};
  edit.insert(edit.end(), changes.begin(), changes.end());
  done(edit);
  open_window(name);
}

void Studio::move(int x, int y) {
  screen_.move(scale_ * x, scale_ * y);
  pause(300);
}

void Studio::press(int x, int y, int button) {
  move(x, y);
  screen_.press(button);
  pause(200);
}

void Studio::release(int button) {
  screen_.release(button);
  pause(300);
}

void Studio::click(int x, int y, int button) {
  press(x, y, button);
  release(button);
}

void Studio::drag(int from_x, int from_y, int to_x, int to_y) {
  screen_.drag(scale_ * from_x, scale_ * from_y, scale_ * to_x, scale_ * to_y);
}

void Studio::key(const std::vector<std::string>& names) {
  screen_.key(names);
  pause(300);
}

void Studio::type(const std::string& text) {
  for (const char letter : text) {
    if (letter == '.') {
      screen_.key({"period"});
    } else {
      screen_.key({letter == ' ' ? "space" : std::string(1, letter)});
    }
  }
  pause(300);
}

void Studio::hover(const std::string& widget) {
  const Box box = place_of(widget);
  screen_.move(box.x + box.width / 2, box.y + box.height / 2);
  pause(300);
}

void Studio::click_on(const std::string& widget) {
  hover(widget);
  screen_.press(1);
  pause(200);
  screen_.release(1);
  pause(300);
}

void Studio::slide(const std::string& slider, double from, double to) {
  const Box box = place_of(slider);
  const int y = box.y + box.height / 2;
  const auto x_of = [&](double part) { return box.x + static_cast<int>(part * box.width); };
  screen_.drag(x_of(from), y, x_of(to), y);
}

void Studio::press_in(const std::string& widget, const Eigen::Vector2d& from,
                      const Eigen::Vector2d& to) {
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

void Studio::scroll_to(const std::string& section, const char* column) {
  const Box box = place_of(std::string("Area/") + column);
  screen_.move(box.x + 4, box.y + box.height / 2);
  turn(kWheelUp, 60);
  for (int i = 0; i < 60 && !is_whole(section, box); ++i) turn(kWheelDown, 1);
  rest();
}

void Studio::open_section(const std::string& section, const char* column,
                          const std::string& widget) {
  scroll_to(section, column);
  if (!places_.find(widget)) click_on(section);
  scroll_to(section, column);
}

void Studio::save(const std::string& name, const Image& image) const {
  const Status written = write_png(image, out_ / (name + ".png"));
  BURNISH_CHECK(written.is_ok(), written.message());
  std::printf("%s\n", name.c_str());
}

void Studio::save_area(const std::string& name, const std::string& area) {
  save(name, with_margin(place_of("Area/" + area), kMargin));
}

Box Studio::picture() const {
  const Box left = place_of(std::string("Area/") + kLeft);
  const Box right = place_of(std::string("Area/") + kRight);
  const int from = left.x + left.width;
  return {from, left.y, right.x - from, left.height};
}

Box Studio::toasts() const {
  const Box box = picture();
  return {box.x, box.y + box.height - scale_ * 90, scale_ * 520, scale_ * 90};
}

Box Studio::with_margin(const Box& box, int margin) const {
  const int by = scale_ * margin;
  return {box.x - by, box.y - by, box.width + 2 * by, box.height + 2 * by};
}

void Studio::toggle_figures() {
  click_on("Menu/View");
  click_on("Menu/Figures");
  rest();
}

void Studio::rest() {
  move(1030, 600);
  settle();
}

void Studio::settle() {
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

void Studio::let_bert_in() {
  const SessionInfo session = connection_.list_sessions().value().at(1);
  const FetchedPages fetched = fetch_all_pages(connection_, session.scan_id);
  bert_ =
      std::make_unique<SessionLink>(connection_, fetched.live_options("fresco", session.key.depth));
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

Box Studio::within_screen(const Box& box) const {
  const Box all = whole();
  const int left = std::max(box.x, 0), top = std::max(box.y, 0);
  return {left, top, std::min(box.x + box.width, all.width) - left,
          std::min(box.y + box.height, all.height) - top};
}

void Studio::turn(int button, int count) {
  for (int i = 0; i < count; ++i) {
    screen_.press(button);
    screen_.release(button);
  }
  pause(200);
}

bool Studio::is_whole(const std::string& section, const Box& column) const {
  const auto area = places_.find("Area/" + section);
  if (!area) return places_.find(section).has_value();  // it is closed
  return area->y + area->height <= column.y + column.height;
}

void Studio::wait_until(const std::function<bool()>& holds) {
  const auto end = std::chrono::steady_clock::now() + kPatience;
  while (!holds()) {
    BURNISH_CHECK(std::chrono::steady_clock::now() < end, "the window does not come to rest");
    pause(50);
  }
}

void Studio::write_scan(const GeneratedScan& scan, const std::string& name) const {
  const auto mesh = generate_scan(scan);
  const Status written =
      mesh.is_ok() ? write_mesh(*mesh, server_.folder / (name + ".ply")) : mesh.status();
  BURNISH_CHECK(written.is_ok(), written.message());
}

void Studio::write_painted(const std::string& name) const {
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

void Studio::done(std::vector<std::string> words) {
  const CommandOutcome outcome = server_.burnish(std::move(words));
  BURNISH_CHECK(outcome.exit_code == 0, outcome.output);
}

}  // namespace burnish
