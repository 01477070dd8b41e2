#include <algorithm>
#include <string_view>
#include <vector>

#include "common/mesh/off/off_text.h"
#include "common/mesh/reading/text_colours.h"
#include "common/mesh/rewrite/format_rewriters.h"
#include "common/mesh/rewrite/moved/placed_normals.h"
#include "common/mesh/rewrite/patch/text_patch.h"

namespace burnish {

namespace {

PositionWords next_off_words(OffText& text) {
  const std::string_view x = text.next_word(), y = text.next_word();
  return {x, y, text.next_word()};
}

/// The facts of all vertices that are known before the first is written.
struct OffAhead {
  TextDigits digits, normal_digits;
  std::vector<Vec3f> normals;  // if there are some
  float largest_channel = 0;

  /// Reads a copy of the file's words, which stands before the first vertex.
  explicit OffAhead(OffText text) {
    for (uint64_t v = 0; v < text.vertices() && text.next_element(); ++v) {
      add_words(next_off_words(text), digits);
      if (text.kind().has_normals) add_normal(next_off_words(text));
      if (!text.kind().has_colours) continue;
      if (const auto rgb = next_colour(text.scanner()))
        largest_channel = burnish::largest_channel(largest_channel, *rgb);
    }
  }

  void add_normal(const PositionWords& words) {
    add_words(words, normal_digits);
    normals.push_back(parse_normal(words).value_or(Vec3f::Zero()));
  }
};

std::vector<AreaVectors> gather_off_areas(const MovedMesh& moved, const OffAhead& ahead) {
  if (ahead.normals.size() != moved.before.size()) return {};
  std::vector<AreaVectors> areas = gather_vertex_areas(moved);
  const Places places = find_places(moved.before);
  if (places.are_shared()) share_areas(places.of_vertex, ahead.normals, areas);
  return areas;
}

}  // namespace

Status rewrite_off(std::span<const uint8_t> bytes, const std::string& name, const MovedMesh& moved,
                   OutputBuffer& output) {
  OffText text(bytes, name, FileSteps(output.budget()));
  const Status header = text.read_header();
  if (!header.is_ok()) return changed_original(name, header.message());
  if (text.vertices() != moved.before.size())
    return changed_original(name, "it has " + std::to_string(text.vertices()) +
                                      " vertices, it had " + std::to_string(moved.before.size()));
  const OffAhead ahead(text);
  const WrittenMesh written(moved, WrittenNumber::of_text(moved, ahead.digits));
  const WrittenNumber normal_number = WrittenNumber::of_normals(ahead.normal_digits);
  const std::vector<AreaVectors> areas = gather_off_areas(written.moved(), ahead);
  const bool has_colours = text.kind().has_colours && moved.after.has_colours();
  BytePatch patch(bytes, output);
  for (uint64_t v = 0; v < moved.before.size() && text.next_element(); ++v) {
    RETURN_IF_ERROR(replace_position(name, written, v, next_off_words(text), patch));
    if (text.kind().has_normals && v < areas.size())
      replace_normal(areas[v], normal_number, next_off_words(text), patch);
    if (has_colours)
      replace_colour(moved.after.colours[v], colour_scale(ahead.largest_channel),
                     next_position_words(text.scanner()), patch);
  }
  patch.finish();
  return Status::ok();
}

}  // namespace burnish
