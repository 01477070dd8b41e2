#include <algorithm>
#include <optional>

#include "common/mesh/off_kind.h"
#include "common/mesh/rewrite/format_rewriters.h"
#include "common/mesh/rewrite/text_patch.h"
#include "common/mesh/text_colours.h"

namespace burnish {

// Reads ahead, in a copy of the scanner.
static float scale_of(TextScanner scanner, const OffKind& kind, size_t vertices) {
  float largest = 0;
  for (size_t v = 0; v < vertices && scanner.next_line(); ++v) {
    for (int skipped = 0; skipped < (kind.has_normals ? 6 : 3); ++skipped) scanner.next_token();
    if (const auto rgb = next_colour(scanner)) largest = largest_channel(largest, *rgb);
  }
  return colour_scale(largest);
}

Status rewrite_off(std::span<const uint8_t> bytes, const std::string& name, const MovedMesh& moved,
                   OutputBuffer& output) {
  TextPatch text = {TextScanner(bytes, name, {.hash_comments = true}), BytePatch(bytes, output)};
  text.scanner.next_line();
  const std::optional<OffKind> kind = parse_off_kind(text.scanner.next_token());
  if (!kind) return changed_original(name, "it does not begin with OFF");
  // The counts are behind the first word or on a line of their own.
  if (text.scanner.next_token().empty()) text.scanner.next_line();
  std::vector<AreaVectors> areas;
  if (kind->has_normals) areas = gather_vertex_areas(moved);
  const bool has_colours = kind->has_colours && moved.after.has_colours();
  const float scale = has_colours ? scale_of(text.scanner, *kind, moved.before.size()) : 0;
  for (uint64_t v = 0; v < moved.before.size(); ++v) {
    text.scanner.next_line();
    RETURN_IF_ERROR(replace_position(name, moved, v, text));
    if (kind->has_normals) replace_normal(areas[v], text);
    if (has_colours) replace_colour(moved.after.colours[v], scale, text);
  }
  text.patch.finish();
  return Status::ok();
}

}  // namespace burnish
