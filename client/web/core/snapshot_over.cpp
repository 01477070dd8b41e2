#include <algorithm>
#include <cmath>

#include "client/model/view/position_text.h"
#include "client/report/length_text.h"
#include "client/web/core/snapshot.h"

namespace burnish {

namespace {

constexpr size_t kLinePointsMax = 512;   // of a drawn line
constexpr double kFarthest = 1'000'000;  // pixels: a point behind the eye has no place

void write_place(const Eigen::Vector2d& pixel, JsonWriter& json) {
  for (const double value : {pixel.x(), pixel.y()})
    json.whole(std::isfinite(value) ? std::lround(std::clamp(value, -kFarthest, kFarthest)) : 0);
}

void write_menu(const PictureMenu& menu, double diagonal, JsonWriter& json) {
  json.open().key("place").open_list();
  write_place(menu.pixel, json);
  json.close_list();
  json.text("position", menu.point ? position_text(*menu.point, diagonal) : "").close();
}

}  // namespace

void write_over(const Workspace& workspace, JsonWriter& json) {
  const Document& document = *workspace.document();
  const Viewport& viewport = workspace.viewport;
  json.key("over").open().key("lasso").open_list();
  const auto& line = viewport.lasso();
  const size_t step = line.size() / kLinePointsMax + 1;
  for (size_t i = 0; i < line.size(); i += step) write_place(line[i], json);
  json.close_list().key("ruler").open_list();
  const Ruler& ruler = document.measuring().ruler;
  for (const Ruler::End& end : ruler.ends())
    write_place(pixel_of(viewport.camera, viewport.size(), end.edited), json);
  const auto length = ruler.length();
  json.close_list().text("rulerLength",
                         length ? length_text(*length, document.unit(), kRulerDigits) : "");
  json.key("menu");
  viewport.menu ? write_menu(*viewport.menu, document.diagonal(), json) : void(json.null());
  json.close();
}

}  // namespace burnish
