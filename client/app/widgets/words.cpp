#include "client/app/widgets/words.h"

#include <cstdio>
#include <ctime>
#include <imgui.h>

#include "client/app/widgets/theme.h"

namespace burnish {

std::string counted(uint64_t count) {
  if (count < 10'000) return std::to_string(count);
  char text[32];
  std::snprintf(text, sizeof text, count < 10'000'000 ? "%.0f k" : "%.1f M",
                count < 10'000'000 ? count / 1e3 : count / 1e6);
  return text;
}

std::string megabytes(uint64_t bytes) {
  char text[32];
  std::snprintf(text, sizeof text, bytes < 10'000'000 ? "%.1f MB" : "%.0f MB", double(bytes) / 1e6);
  return text;
}

std::string day_of(int64_t unix_seconds) {
  const time_t seconds = unix_seconds;
  std::tm local{};
  localtime_r(&seconds, &local);
  char text[32];
  std::strftime(text, sizeof text, "%F", &local);
  return text;
}

std::string text_by_picture(const CutStatus& status) {
  return status.reason == CutReason::kMoving ? std::string() : simplified_text(status);
}

static bool is_inside_letter(char byte) {
  return (static_cast<unsigned char>(byte) & 0xc0) == 0x80;  // of UTF-8
}

std::string cut_to(const std::string& text, float width) {
  if (ImGui::CalcTextSize(text.c_str()).x <= width) return text;
  size_t low = 0, high = text.size();  // bytes that fit, and that do not
  while (high - low > 1) {
    const size_t middle = (low + high) / 2;
    const std::string begun = text.substr(0, middle) + "…";
    (ImGui::CalcTextSize(begun.c_str()).x <= width ? low : high) = middle;
  }
  while (low > 0 && is_inside_letter(text[low])) --low;
  return text.substr(0, low) + "…";
}

void text_with_ellipsis(const std::string& text, float width) {
  const std::string shown = cut_to(text, width);
  ImGui::TextUnformatted(shown.c_str());
  if (shown != text) hint(text.c_str());
}

}  // namespace burnish
