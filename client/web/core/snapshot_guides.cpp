#include <cmath>

#include "client/report/length_text.h"
#include "client/web/core/snapshot.h"

namespace burnish {

namespace {

/// Writes a length in pixels. A tenth of one is not seen.
void write_pixels(const char* name, double pixels, JsonWriter& json) {
  json.number(name, std::round(10 * pixels) / 10);
}

void write_bar(const Workspace& workspace, JsonWriter& json) {
  json.key("bar");
  const auto bar = workspace.document() ? workspace.viewport.scale_bar() : std::nullopt;
  if (!bar) return void(json.null());
  json.open().text("text", length_text(bar->length, workspace.document()->unit()));
  write_pixels("pixels", bar->pixels, json);
  json.close();
}

void write_axes(const Workspace& workspace, JsonWriter& json) {
  json.key("axes");
  const auto gizmo = workspace.document() ? workspace.viewport.axes() : std::nullopt;
  if (!gizmo) return void(json.null());
  json.open();
  write_pixels("middle", gizmo->middle.x(), json);
  write_pixels("radius", gizmo->radius, json);
  write_pixels("endRadius", gizmo->end_radius, json);
  json.key("ends").open_list();
  const auto pointed = workspace.viewport.pointed_axis();
  for (const AxisEnd& end : gizmo->ends) {
    json.open().text("name", name_of(end.axis)).flag("pointed", pointed == end.axis);
    write_pixels("x", end.place.x(), json);
    write_pixels("y", end.place.y(), json);
    json.close();
  }
  json.close_list().close();
}

}  // namespace

std::string guides_of(const Workspace& workspace) {
  JsonWriter json;
  json.open().text("kind", "guides");
  write_bar(workspace, json);
  write_axes(workspace, json);
  return json.close().written();
}

}  // namespace burnish
