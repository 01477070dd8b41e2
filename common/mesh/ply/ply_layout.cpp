#include "common/mesh/ply/ply_layout.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "common/mesh/reading/text_values.h"

namespace burnish {

using SlotNames = std::array<std::string_view, kPlyIgnored>;

static constexpr SlotNames kSlotNames = {"x", "y", "z", "red", "green", "blue", "alpha"};
/// The names that other programs have for the channels.
static constexpr std::array<SlotNames, 2> kOtherSlotNames = {
    {{"x", "y", "z", "diffuse_red", "diffuse_green", "diffuse_blue", "diffuse_alpha"},
     {"x", "y", "z", "r", "g", "b", "a"}}};

/// Returns the names that all channels of a colour have in this file, else the usual ones.
static const SlotNames& slot_names_of(const PlyElement& vertex) {
  const auto has_colour = [&](const SlotNames& names) {
    return vertex.find(names[kPlyRed]) != nullptr && vertex.find(names[kPlyRed + 1]) != nullptr &&
           vertex.find(names[kPlyRed + 2]) != nullptr;
  };
  if (has_colour(kSlotNames)) return kSlotNames;
  const auto other = std::find_if(kOtherSlotNames.begin(), kOtherSlotNames.end(), has_colour);
  return other == kOtherSlotNames.end() ? kSlotNames : *other;
}

static size_t slot_of(const PlyProperty& property, const SlotNames& names) {
  if (property.is_list()) return kPlyIgnored;
  return static_cast<size_t>(std::find(names.begin(), names.end(), property.name) - names.begin());
}

static Status find_vertex_slots(const PlyHeader& header, const std::string& name,
                                PlyLayout& layout) {
  const PlyElement* vertex = header.find("vertex");
  if (vertex == nullptr) return invalid_argument(name + ": the header has no element 'vertex'");
  layout.vertices = vertex->count;
  const SlotNames& names = slot_names_of(*vertex);
  std::array<bool, kPlyIgnored + 1> found = {};
  for (const PlyProperty& property : vertex->properties) {
    const size_t slot = slot_of(property, names);
    layout.vertex_slots.push_back(slot);
    found[slot] = true;
    layout.has_double_positions |= slot < kPlyRed && exceeds_float(property.type);
  }
  for (size_t axis = 0; axis < kPlyRed; ++axis)
    if (!found[axis])
      return invalid_argument(name + ": element 'vertex' has no numeric property " +
                              in_quotes(kSlotNames[axis]));
  layout.has_colours = found[kPlyRed] && found[kPlyRed + 1] && found[kPlyRed + 2];
  return Status::ok();
}

/// Leaves `list` unchanged if the file does not have the element.
static Status find_index_list(const PlyHeader& header, const char* element_name,
                              const std::string& name, size_t& list) {
  const PlyElement* element = header.find(element_name);
  if (element == nullptr || element->count == 0) return Status::ok();
  const auto& properties = element->properties;
  const auto found =
      std::find_if(properties.begin(), properties.end(), [](const PlyProperty& property) {
        return property.is_list() && is_integer(property.type) &&
               (property.name == "vertex_indices" || property.name == "vertex_index");
      });
  if (found == properties.end())
    return invalid_argument(name + ": element " + in_quotes(element_name) +
                            " has no integer list 'vertex_indices'");
  list = static_cast<size_t>(found - properties.begin());
  return Status::ok();
}

Result<PlyLayout> find_ply_layout(const PlyHeader& header, const std::string& name) {
  PlyLayout layout;
  RETURN_IF_ERROR(find_vertex_slots(header, name, layout));
  RETURN_IF_ERROR(find_index_list(header, "face", name, layout.face_list));
  RETURN_IF_ERROR(find_index_list(header, "tristrips", name, layout.strip_list));
  if (layout.face_list == kPlyNoList && layout.strip_list == kPlyNoList &&
      header.find("range_grid") != nullptr)
    return invalid_argument(name +
                            ": a range grid: points in rows and columns without faces (element "
                            "'range_grid'); make a mesh of it first, for example by ply2tri");
  if (layout.face_list == kPlyNoList && layout.strip_list == kPlyNoList)
    return invalid_argument(name + ": the file has no faces, only points");
  return layout;
}

}  // namespace burnish
