#include "common/mesh/obj_texture_uses.h"

#include <map>
#include <string_view>
#include <utility>

#include "common/mesh/text_scanner.h"
#include "common/mesh/text_values.h"

namespace burnish {

namespace {

/// Returns the place from 0 that an OBJ's index means, or kNone.
uint32_t place_from_zero(std::string_view token, size_t so_far) {
  int64_t index;
  if (!parse_integer(token, index) || index == 0) return TextureUses::kNone;
  const int64_t place = index < 0 ? static_cast<int64_t>(so_far) + index : index - 1;
  if (place < 0 || place >= int64_t{TextureUses::kNone}) return TextureUses::kNone;
  return static_cast<uint32_t>(place);
}

/// Walks through an OBJ file and keeps what each vertex meets first.
class TextureUseGatherer {
 public:
  TextureUseGatherer(std::span<const uint8_t> obj, size_t vertices,
                     std::span<const Material> materials)
      : scanner_(obj, "", {.hash_comments = true, .backslash_continues = true}) {
    uses_.coordinate_of.assign(vertices, TextureUses::kNone);
    uses_.material_of.assign(vertices, TextureUses::kNone);
    is_seen_.assign(vertices, false);
    for (size_t m = 0; m < materials.size(); ++m)
      materials_.emplace(materials[m].name, static_cast<uint32_t>(m));
  }

  TextureUses gather() {
    while (scanner_.next_line()) {
      const std::string_view keyword = scanner_.next_token();
      vertices_ += keyword == "v";
      if (keyword == "vt") read_coordinate();
      if (keyword == "usemtl") read_material();
      if (keyword == "f") read_corners();
    }
    for (uint32_t& coordinate : uses_.coordinate_of)
      if (coordinate >= uses_.coordinates.size()) coordinate = TextureUses::kNone;
    return std::move(uses_);
  }

 private:
  void read_coordinate() {
    std::array<float, 2> uv = {0, 0};
    for (float& x : uv) {
      double value;
      if (!parse_double(scanner_.next_token(), value)) break;
      x = static_cast<float>(value);
    }
    uses_.coordinates.push_back(uv);
  }

  void read_material() {
    std::string_view name = scanner_.line_rest();
    while (!name.empty() && (name.front() == ' ' || name.front() == '\t')) name.remove_prefix(1);
    while (!name.empty() && (name.back() == ' ' || name.back() == '\t')) name.remove_suffix(1);
    const auto found = materials_.find(name);
    material_ = found == materials_.end() ? TextureUses::kNone : found->second;
  }

  void read_corners() {
    for (std::string_view token; !(token = scanner_.next_token()).empty();) {
      const size_t slash = std::min(token.find('/'), token.size());
      const uint32_t vertex = place_from_zero(token.substr(0, slash), vertices_);
      if (vertex >= is_seen_.size() || is_seen_[vertex]) continue;
      is_seen_[vertex] = true;
      uses_.material_of[vertex] = material_;
      if (slash == token.size()) continue;
      const std::string_view rest = token.substr(slash + 1);
      uses_.coordinate_of[vertex] =
          place_from_zero(rest.substr(0, rest.find('/')), uses_.coordinates.size());
    }
  }

  TextScanner scanner_;
  std::map<std::string, uint32_t, std::less<>> materials_;
  TextureUses uses_;
  std::vector<bool> is_seen_;
  uint32_t material_ = TextureUses::kNone;
  size_t vertices_ = 0;
};

}  // namespace

TextureUses gather_texture_uses(std::span<const uint8_t> obj, size_t vertices,
                                std::span<const Material> materials) {
  return TextureUseGatherer(obj, vertices, materials).gather();
}

}  // namespace burnish
