// Draws the README's pictures: uses the real window by mouse and keys on its own screen.
// window_pictures OUT [SCALE] [light]   SCALE 2: as on a screen with twice the resolution

#include <cstdio>

#include "tests/system/picture_studio.h"

namespace burnish {
namespace {

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

/// Keeps edges as the scan asks, and takes that back: bands cannot stand beside it.
void draw_edges(Studio& studio) {
  studio.open_section("Keep edges", kLeft, "Keep edges/Kept edges");
  studio.click_on("Keep edges/Kept edges");
  studio.click_on("Keep edges/For this scan");
  studio.rest();
  studio.scroll_to("Keep edges", kLeft);
  studio.save_area("edges", "Keep edges");
  studio.key({"Control_L", "z"});
  studio.click_on("Keep edges");
  studio.rest();
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
  draw_edges(studio);
  draw_bands(studio);
  draw_dialogs(studio);
  draw_colours(studio);
  draw_start_page(studio);  // last: the server is still busy with its scan
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
