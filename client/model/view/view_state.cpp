#include "client/model/view/view_state.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "client/model/files/private_folder.h"
#include "client/model/settings/lighting_toml.h"
#include "common/base/atomic_file.h"

namespace burnish {
namespace {

toml::table camera_to_toml(const Camera& camera) {
  const Vec3d& target = camera.target;
  return toml::table{{"target", toml::array{target.x(), target.y(), target.z()}},
                     {"distance", camera.distance},
                     {"azimuth", camera.azimuth_degrees},
                     {"elevation", camera.elevation_degrees},
                     {"up", name_of(camera.up)},
                     {"orthographic", camera.orthographic}};
}

bool is_sound(const Camera& camera) {
  return camera.target.allFinite() && std::isfinite(camera.distance) && camera.distance > 0 &&
         std::isfinite(camera.azimuth_degrees) && std::abs(camera.elevation_degrees) <= 90;
}

std::optional<Camera> camera_of(const toml::table* table) {
  if (!table) return std::nullopt;
  Camera camera;
  for (int axis = 0; axis < 3; ++axis)
    camera.target[axis] = (*table)["target"][axis].value_or(std::nan(""));
  camera.distance = (*table)["distance"].value_or(0.0);
  camera.azimuth_degrees = (*table)["azimuth"].value_or(0.0);
  camera.elevation_degrees = (*table)["elevation"].value_or(0.0);
  const auto up = parse_up_axis((*table)["up"].value_or(std::string_view("y")));
  if (up.is_ok()) camera.up = *up;
  camera.orthographic = (*table)["orthographic"].value_or(false);
  return is_sound(camera) ? std::optional(camera) : std::nullopt;
}

toml::array ends_to_toml(const ColourEnds& ends) {
  return toml::array{ends.low, ends.high};
}

/// `otherwise`: where the table has none, as those of earlier versions.
ColourEnds ends_of(const toml::table& table, const char* key, double otherwise) {
  const auto end = [&](size_t number) {
    return clamped_end(table[key][number].value_or(otherwise));
  };
  return {end(0), end(1)};
}

toml::table view_to_toml(const ViewKey& key, const ViewState& view) {
  toml::array bookmarks;
  for (size_t i = 0; i < std::min(view.bookmarks.size(), kBookmarksMax); ++i)
    bookmarks.push_back(camera_to_toml(view.bookmarks[i]));
  return toml::table{{"server", key.server},
                     {"session", key.session},
                     {"scan", view.scan},
                     {"camera", camera_to_toml(view.camera)},
                     {"flat", view.options.flat},
                     {"wireframe", view.options.wireframe},
                     {"split", view.options.split},
                     {"split_at", view.options.split_at},
                     {"displacement", ends_to_toml(view.options.displacement)},
                     {"curvature", ends_to_toml(view.options.curvature)},
                     {"scale_bar", view.options.scale_bar},
                     {"axes", view.options.axes},
                     {"light", to_toml(view.options.lighting)},
                     {"colour", static_cast<int>(view.colour)},
                     {"bookmarks", bookmarks}};
}

ViewOptions options_of(const toml::table& table) {
  ViewOptions options;
  options.flat = table["flat"].value_or(false);
  options.wireframe = table["wireframe"].value_or(false);
  options.split = table["split"].value_or(false);
  options.split_at = std::clamp(table["split_at"].value_or(options.split_at), 0.05, 0.95);
  options.displacement = ends_of(table, "displacement", table["displacement_range"].value_or(1.0));
  options.curvature = ends_of(table, "curvature", 1);
  options.scale_bar = table["scale_bar"].value_or(options.scale_bar);
  options.axes = table["axes"].value_or(options.axes);
  if (const toml::table* light = table["light"].as_table()) options.lighting = lighting_of(*light);
  return options;
}

std::optional<ViewState> view_of(const toml::table& table) {
  const auto camera = camera_of(table["camera"].as_table());
  if (!camera) return std::nullopt;
  ViewState view{table["scan"].value_or(std::string()), *camera, options_of(table)};
  const int colour = table["colour"].value_or(0);
  if (colour >= 0 && colour <= static_cast<int>(ColourBy::kScan))
    view.colour = static_cast<ColourBy>(colour);
  const toml::array* const bookmarks = table["bookmarks"].as_array();
  for (size_t i = 0; bookmarks && i < std::min(bookmarks->size(), kBookmarksMax); ++i)
    if (const auto bookmark = camera_of((*bookmarks)[i].as_table()))
      view.bookmarks.push_back(*bookmark);
  return view;
}

ViewKey key_of(const toml::table& table) {
  return {table["server"].value_or(std::string()), table["session"].value_or(std::string())};
}

/// Returns the tables of the file, newest first; none of a file that is missing or damaged.
std::vector<toml::table> read_views(const std::filesystem::path& file) {
  std::vector<toml::table> views;
  std::error_code ignored;
  if (!std::filesystem::exists(file, ignored)) return views;
  try {
    toml::table all = toml::parse_file(file.string());
    if (toml::array* const array = all["views"].as_array())
      for (toml::node& node : *array)
        if (toml::table* const table = node.as_table()) views.push_back(std::move(*table));
  } catch (const toml::parse_error&) {
    views.clear();
  }
  return views;
}

}  // namespace

std::optional<ViewState> read_view(const std::filesystem::path& file, const ViewKey& key) {
  for (const toml::table& table : read_views(file))
    if (key_of(table) == key) return view_of(table);
  return std::nullopt;
}

std::optional<UpAxis> read_up(const std::filesystem::path& file, const std::string& scan) {
  for (const toml::table& table : read_views(file))
    if (const auto view = view_of(table); view && view->scan == scan) return view->camera.up;
  return std::nullopt;
}

Status write_view(const std::filesystem::path& file, const ViewKey& key, const ViewState& view) {
  std::vector<toml::table> views = read_views(file);
  std::erase_if(views, [&](const toml::table& table) { return key_of(table) == key; });
  views.insert(views.begin(), view_to_toml(key, view));
  if (views.size() > kViewsMax) views.resize(kViewsMax);
  toml::array array;
  for (toml::table& table : views) array.push_back(std::move(table));
  std::ostringstream text;
  text << toml::table{{"views", std::move(array)}} << "\n";
  std::error_code ignored;
  const auto folder = std::filesystem::absolute(file).parent_path();
  if (!std::filesystem::exists(folder, ignored)) RETURN_IF_ERROR(make_private_folder(folder));
  return write_file(file, text.str(), FileAccess::kUserOnly);
}

}  // namespace burnish
