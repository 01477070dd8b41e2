#include <optional>

#include "common/mesh/off_kind.h"
#include "common/mesh/rewrite/format_rewriters.h"
#include "common/mesh/rewrite/text_patch.h"

namespace burnish {

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
  for (uint64_t v = 0; v < moved.before.size(); ++v) {
    text.scanner.next_line();
    RETURN_IF_ERROR(replace_position(name, moved, v, text));
    if (kind->has_normals) replace_normal(areas[v], text);
  }
  text.patch.finish();
  return Status::ok();
}

}  // namespace burnish
