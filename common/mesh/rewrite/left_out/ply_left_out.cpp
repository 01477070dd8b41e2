#include <algorithm>
#include <initializer_list>
#include <string_view>

#include "common/mesh/ply/ply_header.h"
#include "common/mesh/ply/ply_layout.h"
#include "common/mesh/reading/text_scanner.h"
#include "common/mesh/reading/text_values.h"
#include "common/mesh/rewrite/left_out/left_out_list.h"

namespace burnish {

static bool is_one_of(std::string_view name, std::initializer_list<std::string_view> names) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

static void list_vertex_property(const PlyProperty& property, LeftOutList& list) {
  const std::string_view name = property.name;
  if (is_one_of(name, {"nx", "ny", "nz"})) return list.add("normals");
  if (is_one_of(name, {"s", "t", "u", "v", "texture_u", "texture_v"}))
    return list.add("texture coordinates");
  list.add("property " + in_quotes(name));
}

static void list_face_property(const PlyProperty& property, LeftOutList& list) {
  const std::string_view name = property.name;
  if (is_one_of(name, {"vertex_indices", "vertex_index"})) return;
  if (is_one_of(name, {"nx", "ny", "nz"})) return list.add("normals of faces");
  if (is_one_of(name, {"texcoord", "texnumber"})) return list.add("texture coordinates");
  if (is_one_of(name, {"red", "green", "blue", "alpha"})) return list.add("colours of faces");
  list.add("face property " + in_quotes(name));
}

static bool has_comments(std::span<const uint8_t> header) {
  TextScanner scanner(header, "");
  while (scanner.next_line())
    if (is_one_of(scanner.next_token(), {"comment", "obj_info"})) return true;
  return false;
}

bool list_ply_extras(std::span<const uint8_t> bytes, size_t triangles, LeftOutList& list) {
  const auto header = parse_ply_header(bytes, "");
  if (!header.is_ok()) return false;
  const auto layout = find_ply_layout(*header, "");
  if (!layout.is_ok()) return false;
  for (const PlyElement& element : header->elements) {
    const bool is_mesh = is_one_of(element.name, {"vertex", "face", "tristrips"});
    list.add_if(!is_mesh && element.count > 0, "element " + in_quotes(element.name));
    if (!is_mesh) continue;
    for (size_t p = 0; p < element.properties.size(); ++p) {
      const PlyProperty& property = element.properties[p];
      if (element.name != "vertex")
        list_face_property(property, list);
      else if (layout->vertex_slots[p] == kPlyIgnored)
        list_vertex_property(property, list);
    }
    list.add_if(element.name == "face" && element.count < triangles, "polygons");
  }
  list.add_if(has_comments(bytes.first(header->body_offset)), "comments");
  return true;
}

}  // namespace burnish
