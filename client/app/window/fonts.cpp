#include "client/app/window/fonts.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <imgui.h>
#include <map>
#include <memory>
#include <vector>

#include "client/app/widgets/theme.h"

namespace burnish {
namespace {

constexpr const char* kFontFile = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf";
constexpr float kTitlePixels = 22;

// Latin with its extensions, Greek and Cyrillic, general punctuation, arrows, mathematical
// operators, and the box for letters that are missing.
constexpr ImWchar kAlways[] = {0x20,   0x24f,  0x370,  0x52f,  0x1e00, 0x1eff, 0x2010, 0x2044,
                               0x2190, 0x21ff, 0x2200, 0x22ff, 0xfffd, 0xfffd, 0};

/// Letters whose font is looked for together.
struct Script {
  char16_t first, last;
};
constexpr std::array<Script, 7> kScripts = {{{0x0530, 0x08ff},    // Armenian to Arabic
                                             {0x0900, 0x1cff},    // of India and its neighbours
                                             {0x1d00, 0x2e7f},    // signs
                                             {0x2e80, 0x9fff},    // Chinese and Japanese
                                             {0xa000, 0xabff},    // of Africa and Asia
                                             {0xac00, 0xd7ff},    // Korean
                                             {0xf900, 0xffff}}};  // other forms of the above

std::string font_with(char16_t letter) {
  char command[96];
  std::snprintf(command, sizeof command, "fc-list -f '%%{file}\\n' ':charset=%x' 2>/dev/null",
                static_cast<unsigned>(letter));
  const std::unique_ptr<FILE, int (*)(FILE*)> answer(popen(command, "r"), pclose);
  char line[1024];
  if (!answer || !std::fgets(line, sizeof line, answer.get())) return {};
  std::string file(line);
  file.erase(file.find_last_not_of('\n') + 1);
  return file;
}

// Asks once for each letter.
const std::string& known_font_with(char16_t letter) {
  static std::map<char16_t, std::string> known;
  const auto [entry, is_new] = known.try_emplace(letter);
  if (is_new) entry->second = font_with(letter);
  return entry->second;
}

std::string utf8_of(char16_t letter) {
  return {static_cast<char>(0xe0 | letter >> 12), static_cast<char>(0x80 | (letter >> 6 & 0x3f)),
          static_cast<char>(0x80 | (letter & 0x3f))};
}

/// Ranges of ImGui must live as long as its fonts.
std::vector<ImWchar>& ranges_with(const std::set<char16_t>& letters) {
  static std::vector<ImWchar> ranges;
  ranges.assign(std::begin(kAlways), std::end(kAlways) - 1);
  for (const char16_t letter : letters) ranges.insert(ranges.end(), 2, letter);
  ranges.push_back(0);
  return ranges;
}

// Adds the fonts of the scripts that occur. Returns a letter of each script that has none.
std::string add_other_fonts(float pixels, const std::set<char16_t>& letters,
                            const ImWchar* ranges) {
  std::string missing;
  std::set<std::string> added = {kFontFile};
  ImFontConfig config;
  config.MergeMode = true;
  for (const Script& script : kScripts) {
    const auto letter = letters.lower_bound(script.first);
    if (letter == letters.end() || *letter > script.last) continue;
    const std::string& file = known_font_with(*letter);
    if (file.empty()) missing += utf8_of(*letter);
    if (file.empty() || !added.insert(file).second) continue;
    ImGui::GetIO().Fonts->AddFontFromFileTTF(file.c_str(), pixels, &config, ranges);
  }
  return missing;
}

}  // namespace

std::string load_fonts(float scale, const std::set<char16_t>& letters) {
  ImFontAtlas& fonts = *ImGui::GetIO().Fonts;
  fonts.Clear();
  std::error_code error;
  if (!std::filesystem::exists(kFontFile, error)) {
    ImFontConfig config;
    config.SizePixels = std::round(13 * scale);
    fonts.AddFontDefault(&config);
    return {};
  }
  const float pixels = std::round(kEmPixels * scale);
  const std::vector<ImWchar>& ranges = ranges_with(letters);
  fonts.AddFontFromFileTTF(kFontFile, pixels, nullptr, ranges.data());
  std::string missing = add_other_fonts(pixels, letters, ranges.data());
  fonts.AddFontFromFileTTF(kFontFile, std::round(kTitlePixels * scale), nullptr, kAlways);
  return missing;
}

}  // namespace burnish
