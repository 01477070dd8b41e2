#include "common/mesh/obj/mtl_reader.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <string_view>

#include "common/base/limits.h"
#include "common/mesh/reading/text_scanner.h"
#include "common/mesh/reading/text_values.h"

namespace burnish {

namespace {

std::string_view without_blanks(std::string_view text) {
  constexpr std::string_view kBlanks = " \t\r\"";  // some programs put names in quotes
  const size_t first = std::min(text.find_first_not_of(kBlanks), text.size());
  text.remove_prefix(first);
  return text.substr(0, text.find_last_not_of(kBlanks) + 1);
}

std::string_view first_word(std::string_view text) {
  text.remove_prefix(std::min(text.find_first_not_of(" \t"), text.size()));
  return text.substr(0, text.find_first_of(" \t"));
}

/// Leaves out a comment behind a file's name. A '#' may also belong to the name: "wall #2.png".
std::string_view without_comment(std::string_view name) {
  constexpr size_t kExtensionMax = 6;  // with its dot
  for (size_t at = name.find('#'); at != std::string_view::npos; at = name.find('#', at + 1)) {
    const std::string_view before = without_blanks(name.substr(0, at));
    const size_t dot = before.rfind('.');
    const bool is_apart = at > 0 && (name[at - 1] == ' ' || name[at - 1] == '\t');
    const bool is_name = dot != std::string_view::npos && before.size() - dot <= kExtensionMax;
    if (is_apart && is_name) return before;
  }
  return name;
}

/// Returns how well a statement's picture shows the colour of a surface: 0: not at all.
int rank_of(std::string_view keyword) {
  if (equals_ignoring_case(keyword, "map_Kd")) return 3;
  if (equals_ignoring_case(keyword, "map_Ka")) return 2;
  return equals_ignoring_case(keyword, "map_Ke") ? 1 : 0;
}

bool starts_ignoring_case(std::string_view text, std::string_view beginning) {
  return equals_ignoring_case(text.substr(0, beginning.size()), beginning);
}

bool names_a_picture(std::string_view keyword) {
  if (starts_ignoring_case(keyword, "map_")) return !equals_ignoring_case(keyword, "map_aat");
  constexpr std::array<std::string_view, 5> kOthers = {"bump", "disp", "decal", "refl", "norm"};
  return std::any_of(kOthers.begin(), kOthers.end(),
                     [&](std::string_view k) { return equals_ignoring_case(keyword, k); });
}

/// Reads one MTL file by its statements.
class MtlReader {
 public:
  MtlReader(std::span<const uint8_t> bytes, const std::string& name, const FileSteps& steps)
      : scanner_(bytes, name, {.hash_comments = true, .backslash_continues = true}, 0, steps) {}

  MaterialFile read() {
    while (scanner_.next_line()) {
      const std::string_view keyword = scanner_.next_token();
      if (equals_ignoring_case(keyword, "newmtl")) begin_material();
      if (keyword == "Kd") read_diffuse();
      if (names_a_picture(keyword)) read_picture_name(keyword);
    }
    return std::move(file_);
  }

 private:
  void begin_material() {
    file_.materials.push_back({.name = std::string(without_blanks(scanner_.line_rest()))});
    picture_rank_ = 0;
  }

  void read_diffuse() {
    Rgba8 colour = {0, 0, 0, 255};
    for (size_t i = 0; i < 3; ++i) {
      double value;
      if (!parse_double(scanner_.next_token(), value) || std::isnan(value)) return;
      colour[i] = static_cast<uint8_t>(std::lround(255 * std::clamp(value, 0.0, 1.0)));
    }
    if (!file_.materials.empty()) file_.materials.back().diffuse = colour;
  }

  /// The name is the rest of the line after the options. It may have blanks.
  void read_picture_name(std::string_view keyword) {
    Material drawn;  // takes the options
    while (first_word(scanner_.line_rest()).starts_with('-'))
      read_option(scanner_.next_token(), drawn);
    const std::string name(without_comment(without_blanks(scanner_.line_rest())));
    if (name.empty()) return;
    if (known_pictures_.insert(name).second) file_.pictures.push_back(name);
    const int rank = rank_of(keyword);
    if (file_.materials.empty() || rank == 0 || rank < picture_rank_) return;
    picture_rank_ = rank;
    Material& material = file_.materials.back();
    material.picture = name;
    material.wraps = drawn.wraps;
    material.scale = drawn.scale;
    material.offset = drawn.offset;
  }

  void read_option(std::string_view option, Material& drawn) {
    if (option == "-o") return read_numbers(drawn.offset);
    if (option == "-s") return read_numbers(drawn.scale);
    std::array<double, 2> ignored;
    if (option == "-t") return read_numbers(ignored);
    const std::string_view value = scanner_.next_token();
    if (option == "-mm") scanner_.next_token();
    if (option == "-clamp" && value == "on")
      drawn.wraps = {TextureWrap::kClamp, TextureWrap::kClamp};
  }

  /// Reads one to three numbers: u, v and w.
  void read_numbers(std::array<double, 2>& values) {
    for (size_t i = 0; i < 3; ++i) {
      double value;
      if (!parse_double(first_word(scanner_.line_rest()), value)) return;
      scanner_.next_token();
      if (i < 2) values[i] = value;
    }
  }

  TextScanner scanner_;
  MaterialFile file_;
  int picture_rank_ = 0;  // of the last material's picture
  std::set<std::string> known_pictures_;
};

}  // namespace

Result<MaterialFile> read_material_file(std::span<const uint8_t> bytes, const std::string& name,
                                        const FileSteps& steps) {
  if (bytes.size() > kMaterialFileBytesMax)
    return invalid_argument(name + ": a material file of " + std::to_string(bytes.size()) +
                            " bytes, the limit is " + std::to_string(kMaterialFileBytesMax));
  RETURN_IF_ERROR(check_line_lengths(bytes, name, steps));
  return MtlReader(bytes, name, steps).read();
}

}  // namespace burnish
