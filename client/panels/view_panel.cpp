#include <iterator>
#include <string>

#include "client/panels/panels.h"
#include "client/scene/standard_view.h"

namespace burnish {
namespace {

constexpr Option kColours[] = {{"clay", "Clay"},
                               {"beta", "Gradient scale β"},
                               {"curvature", "Curvature"},
                               {"displacement", "Displacement"},
                               {"scan", "Colours of the scan"}};  // as ColourBy

constexpr Slider kSplit = {.name = "Place of the split",
                           .hint = "",
                           .low = 0.05,
                           .high = 0.95,
                           .digits = 0,
                           .has_title = false};

void choose_colour(Document& document, Widgets& widgets) {
  const std::span options(kColours, std::size(kColours) - (document.has_colours() ? 0 : 1));
  const auto chosen = static_cast<size_t>(document.colour());
  const int taken =
      widgets.choice({"Colour", options}, chosen < options.size() ? static_cast<int>(chosen) : -1);
  if (taken >= 0) document.set_colour(static_cast<ColourBy>(taken));
}

/// The ends of the colours in the scan's units. `scale`: of an end, in these.
void show_ends(double scale, const std::string& unit, ColourEnds& ends, Widgets& widgets) {
  const auto slider = [&](const char* name, const char* hint, double& end) {
    double value = end * scale;
    const Slider shown{.name = name,
                       .hint = hint,
                       .low = kColourEndMin * scale,
                       .high = kColourEndMax * scale,
                       .scale = SliderScale::kLogarithmic,
                       .note = unit.c_str()};
    if (widgets.slider(shown, value) != SliderChange::kStill) end = clamped_end(value / scale);
  };
  slider("Blue below zero", "What lies so far below zero, or farther, is full blue.", ends.low);
  slider("Red above zero", "What lies so far above zero, or farther, is full red.", ends.high);
  widgets.enable(!(ends == ColourEnds()));
  if (widgets.button("Automatic ends", "Chooses both ends by the scan.")) ends = {};
  widgets.enable(true);
}

void show_ends(const Document& document, ViewOptions& options, Widgets& widgets) {
  const std::string& unit = document.unit();
  if (document.colour() == ColourBy::kDisplacement)
    show_ends(document.cell_size(), unit.empty() ? unit : "in " + unit, options.displacement,
              widgets);
  if (document.colour() == ColourBy::kCurvature)
    show_ends(document.curve().kappa_range() / document.length_unit(),
              unit.empty() ? unit : "in 1/" + unit, options.curvature, widgets);
}

void show_toggles(Viewport& viewport, Widgets& widgets) {
  ViewOptions& options = viewport.options;
  widgets.begin_row(2);
  widgets.check("Flat", "Gives each triangle one shade.", options.flat);
  widgets.check("Wireframe", "", options.wireframe);
  widgets.end_row();
  widgets.begin_row(2);
  widgets.check("Split",
                "Shows the original on the left, the edited surface on the right. Hold Space to "
                "see the original everywhere.",
                options.split);
  widgets.check("Original", "Shows the surface before all edits.", viewport.hold_original);
  widgets.end_row();
  widgets.begin_row(2);
  widgets.check("Scale bar",
                "A round length, in pictures that are saved too. With perspective it holds at the "
                "point around which the view turns.",
                options.scale_bar);
  widgets.check("Axes",
                "The scan's axes. A click on an end looks along the axis from there, a drag turns "
                "the view.",
                options.axes);
  widgets.end_row();
  if (options.split) widgets.slider(kSplit, options.split_at);
}

void show_bookmarks(Viewport& viewport, Widgets& widgets) {
  widgets.begin_row(2);
  if (widgets.button("Frame all")) viewport.go_home();
  if (widgets.button("Bookmark")) viewport.add_bookmark();
  widgets.end_row();
  constexpr size_t kInRow = 6;
  for (size_t i = 0; i < viewport.bookmarks.size(); ++i) {
    if (i % kInRow == 0) widgets.begin_row(kInRow);
    const std::string label = std::to_string(i + 1);
    const std::string name = "Bookmark " + label;
    if (widgets.button(name.c_str(), "", Pressed::kIsNoSwitch, label.c_str()))
      viewport.camera = viewport.bookmarks[i];
    if (i % kInRow == kInRow - 1 || i + 1 == viewport.bookmarks.size()) widgets.end_row();
  }
}

}  // namespace

void show_view(Workspace& workspace, Widgets& widgets) {
  Document& document = *workspace.document();
  Viewport& viewport = workspace.viewport;
  choose_colour(document, widgets);
  show_ends(document, viewport.options, widgets);
  show_toggles(viewport, widgets);
  show_bookmarks(viewport, widgets);
  if (widgets.check("Left button turns the view", "", viewport.navigate_mode))
    viewport.measure_mode &= !viewport.navigate_mode;
  widgets.text(status_text(document.surface().status()).c_str());
  widgets.text(("depth " + std::to_string(document.depth())).c_str());
}

void show_camera(Workspace& workspace, Widgets& widgets) {
  Viewport& viewport = workspace.viewport;
  static constexpr Option kUps[] = {{"x", "x"},   {"y", "y"},   {"z", "z"},
                                    {"-x", "-x"}, {"-y", "-y"}, {"-z", "-z"}};  // as UpAxis
  const int up =
      widgets.choice({.name = "Up",
                      .options = kUps,
                      .hint = "The scan's axis that points up. It is kept with the session.",
                      .is_labelled = true},
                     static_cast<int>(viewport.camera.up));
  if (up >= 0) viewport.set_up(static_cast<UpAxis>(up));
  static constexpr const char* kViews[] = {"Front", "Back", "Right",
                                           "Left",  "Top",  "Bottom"};  // as StandardView
  constexpr int kInRow = 3;
  for (int i = 0; i < kStandardViews; ++i) {
    if (i % kInRow == 0) widgets.begin_row(kInRow);
    if (widgets.button(kViews[i])) viewport.show_from(static_cast<StandardView>(i));
    if (i % kInRow == kInRow - 1) widgets.end_row();
  }
  widgets.check("Orthographic",
                "Draws without perspective: equal lengths are equal in the picture.",
                viewport.camera.orthographic);
}

}  // namespace burnish
