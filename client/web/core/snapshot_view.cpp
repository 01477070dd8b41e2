#include <algorithm>
#include <cmath>

#include "client/model/documents/figures.h"
#include "client/model/view/colour_scale.h"
#include "client/report/length_text.h"
#include "client/web/core/snapshot.h"

namespace burnish {

namespace {

void write_options(const Workspace& workspace, JsonWriter& json) {
  static constexpr const char* kColours[] = {"clay", "beta", "curvature", "displacement",
                                             "scan"};  // as ColourBy
  const Document& document = *workspace.document();
  const Viewport& viewport = workspace.viewport;
  const ViewOptions& options = viewport.options;
  json.key("view").open().text("colour", kColours[static_cast<int>(document.colour())]);
  json.flag("wireframe", options.wireframe);
  json.flag("split", options.split).number("splitAt", options.split_at);
  json.flag("original", viewport.hold_original);
  json.flag("orthographic", viewport.camera.orthographic);
  json.text("status", status_text(document.surface().status())).close();
}

void write_scale(const Workspace& workspace, JsonWriter& json) {
  json.key("scale");
  const auto scale = colour_scale(*workspace.document(), workspace.viewport);
  if (!scale) return void(json.null());
  json.open().text("title", scale->title).text("low", scale->low).text("middle", scale->middle);
  json.text("high", scale->high).number("part", scale->part).text("value", scale->value).close();
}

void write_figures(const char* name, const std::vector<Figure>& figures, JsonWriter& json) {
  json.key(name).open_list();
  for (const Figure& figure : figures)
    json.open().text("name", figure.name).text("value", figure.value).close();
  json.close_list();
}

// Roots of the areas, so that a small part is seen beside the part that stays.
void write_numbers(const Document& document, UpAxis up, JsonWriter& json) {
  const auto& measured = document.measuring().deviation();
  const bool has_moved = measured && !measured->deviation.is_zero();
  json.key("numbers").open();
  write_figures("deviation", deviation_figures(document, up), json);
  json.flag("current", document.measuring().is_deviation_of(document.shown()));
  json.key("histogram").open_list();
  if (has_moved)
    for (const double area : measured->deviation.histogram) json.number(std::sqrt(area));
  json.close_list();
  json.text("range",
            has_moved ? length_text(measured->deviation.histogram_range, document.unit()) : "");
  json.whole("rulerPoints", static_cast<int64_t>(document.measuring().ruler.ends().size()));
  write_figures("ruler", ruler_figures(document), json);
  json.close();
}

}  // namespace

void write_view(const Workspace& workspace, JsonWriter& json) {
  write_options(workspace, json);
  write_scale(workspace, json);
  write_numbers(*workspace.document(), workspace.viewport.camera.up, json);
}

}  // namespace burnish
