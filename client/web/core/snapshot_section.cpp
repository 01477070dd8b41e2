#include <cmath>

#include "client/model/view/section_view.h"
#include "client/web/core/snapshot.h"

namespace burnish {

namespace {

constexpr size_t kSectionPathPointsMax = 2000;  // of a drawn surface
constexpr double kRulerLength = 10'000;         // in the drawing

// The margins of section_plot.tsx, in lengths of the ruler.
constexpr double kBesideRuler = 1 / 18.0, kHalfHeight = 0.14 * (1 + 2 * kBesideRuler);
constexpr double kWayTick = 0.125, kHeightTick = 0.05;  // least distance of two numbers

/// Returns the path of an SVG. A line keeps both its ends.
std::string path_of(const std::vector<SectionLine>& lines, const SectionView& view) {
  size_t points = 0;
  for (const SectionLine& line : lines) points += line.points.size();
  const size_t step = points / kSectionPathPointsMax + 1;
  std::string path;
  for (const SectionLine& line : lines) {
    const size_t last = line.points.size() - 1;
    for (size_t i = 0; i <= last; i = i == last ? i + 1 : std::min(i + step, last)) {
      const Eigen::Vector2d at = kRulerLength * view.place(line.points[i]);
      path += (i == 0 ? "M" : "L") + std::to_string(std::lround(at.x())) + " " +
              std::to_string(std::lround(-at.y()));
    }
  }
  return path;
}

void write_ticks(const char* name, const std::vector<LengthTick>& ticks, JsonWriter& json) {
  json.key(name).open_list();
  for (const LengthTick& tick : ticks)
    json.open().whole("at", std::lround(kRulerLength * tick.at)).text("text", tick.text).close();
  json.close_list();
}

}  // namespace

void write_section(const Document& document, const FrontState& state, JsonWriter& json) {
  const Measuring& measuring = document.measuring();
  json.key("section");
  if (!measuring.plane() || measuring.ruler.ends().size() < 2) return void(json.null());
  const SectionView view(*measuring.plane(), measuring.ruler);
  const auto& section = measuring.section();
  json.open().flag("ready", section.has_value());
  json.text("original", section ? path_of(section->original, view) : "");
  json.text("edited", section ? path_of(section->edited, view) : "");
  const double exaggeration = state.section_exaggeration, half = kHalfHeight / exaggeration;
  json.number("exaggeration", exaggeration);
  const std::string& unit = document.unit();
  write_ticks("ways", view.ticks(-kBesideRuler, 1 + kBesideRuler, kWayTick, unit), json);
  write_ticks("heights", view.ticks(-half, half, kHeightTick / exaggeration, unit), json);
  json.close();
}

}  // namespace burnish
