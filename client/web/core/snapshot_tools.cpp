#include <algorithm>
#include <cmath>

#include "client/tools/band_choice.h"
#include "client/web/core/snapshot.h"
#include "common/base/ratio.h"
#include "common/edit/wavelength.h"

namespace burnish {

namespace {

constexpr int kSteps = 96;  // of drawn lines

// The root lifts the tails, which hold the detail that users edit.
void write_histogram(const ScanDescription& scan, JsonWriter& json) {
  json.key("histogram").open_list();
  if (scan.prepared)
    for (const float bin : scan.prepared->histogram) json.number(std::sqrt(std::max(0.0f, bin)));
  json.close_list();
}

void write_curve(const Document& document, JsonWriter& json) {
  const CurveEditor& editor = document.curve();
  const TransferCurve curve = editor.curve();
  json.key("curve").open().text("text", curve.to_string()).key("points").open_list();
  for (const TransferCurve::Point& point : editor.points()) {
    const Eigen::Vector2d place = editor.place_of(point);
    json.open().number("kappa", point.kappa).number("alpha", point.alpha);
    json.number("x", place.x()).number("y", place.y()).close();
  }
  json.close_list().key("line").open_list();
  for (int i = 0; i <= kSteps; ++i) {
    TransferCurve::Point point = editor.point_at({double(i) / kSteps, 0});
    point.alpha = curve.alpha(point.kappa);
    json.number(std::clamp(editor.place_of(point).y(), 0.0, 1.0));
  }
  json.close_list();
  json.whole("dragged", editor.dragged() ? static_cast<int64_t>(*editor.dragged()) : -1);
  json.number("kappaRange", editor.kappa_range()).number("alphaMax", editor.alpha_max());
  json.number("contrast", curve.contrast());
  write_histogram(document.scan(), json);
  json.close();
}

void write_bands(const Document& document, JsonWriter& json) {
  const Equaliser& equaliser = document.equaliser();
  json.key("bands").open_list();
  for (size_t number = 1; number <= equaliser.bands.size(); ++number) {
    const Band& band = equaliser.bands[number - 1];
    json.open().number("size", band.size).number("gain", band.gain);
    json.text("details", details_of(equaliser, number)).close();
  }
  json.close_list().key("response").open_list();
  const double least = kWaveCellsMin * document.cell_size(), most = document.diagonal();
  for (int i = 0; i <= kSteps; ++i)
    json.number(response(equaliser, between_by_ratio(least, most, double(i) / kSteps)));
  json.close_list();
}

void write_palette(const Document& document, JsonWriter& json) {
  json.key("palette").open_list();
  for (const PaletteCurve& curve : document.palette().curves)
    json.open()
        .text("name", curve.name)
        .whole("colour", curve.colour)
        .text("curve", curve.curve.to_string())
        .close();
  json.close_list();
}

void write_brush(const Brush& brush, JsonWriter& json) {
  static constexpr const char* kFallOffs[] = {"smooth", "linear", "sharp", "constant"};
  json.key("brush").open().number("radius", brush.radius).number("strength", brush.strength);
  json.number("beta", brush.beta).text("fallOff", kFallOffs[static_cast<int>(brush.fall_off)]);
  json.text("paints", painted_word(brush)).flag("through", !brush.connected).close();
}

void write_pointer(const Workspace& workspace, JsonWriter& json) {
  const Viewport& viewport = workspace.viewport;
  json.text("tool", viewport.measure_mode ? "measure" : viewport.navigate_mode ? "look" : "paint");
  const auto& wish = viewport.lasso_wish;
  json.text("lasso", !wish ? "off" : wish->release ? "release" : "protect");
}

}  // namespace

void write_tools(const Workspace& workspace, JsonWriter& json) {
  const Document& document = *workspace.document();
  json.number("beta", document.beta()).number("fidelity", document.curve().fidelity());
  write_curve(document, json);
  json.flag("keepsEdges", document.edges().is_on());
  write_bands(document, json);
  write_palette(document, json);
  write_brush(document.brush().brush, json);
  write_pointer(workspace, json);
}

}  // namespace burnish
