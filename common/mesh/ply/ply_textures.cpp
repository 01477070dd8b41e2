#include "common/mesh/ply/ply_textures.h"

#include <algorithm>
#include <string_view>

#include "common/mesh/ply/ply_header.h"

namespace burnish {

// MeshLab writes "TextureFile", CloudCompare "TEXTUREFILE".
static bool begins_with(std::string_view line, std::string_view mark) {
  const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; };
  return line.size() >= mark.size() &&
         std::equal(mark.begin(), mark.end(), line.begin(),
                    [&](char a, char b) { return lower(a) == lower(b); });
}

std::vector<std::string> textures_in_ply(std::span<const uint8_t> bytes) {
  constexpr std::string_view kMark = "comment TextureFile ", kEnds = "\r\n";
  std::vector<std::string> names;
  const auto header = parse_ply_header(bytes, "");
  if (!header.is_ok()) return names;
  std::string_view rest(reinterpret_cast<const char*>(bytes.data()), header->body_offset);
  while (!rest.empty()) {
    const std::string_view line = rest.substr(0, rest.find_first_of(kEnds));
    rest.remove_prefix(std::min(line.size() + 1, rest.size()));
    if (!begins_with(line, kMark)) continue;
    const std::string_view name = line.substr(kMark.size());
    const size_t begin = name.find_first_not_of(" \t");
    if (begin == std::string_view::npos) continue;
    names.emplace_back(name.substr(begin, name.find_last_not_of(" \t") + 1 - begin));
  }
  return names;
}

}  // namespace burnish
