#pragma once

#include <imgui.h>

#include "common/base/types.h"

namespace burnish {

/// Sizes are in em, the font's height, so that one number scales all.
inline float em(float count) {
  return count * ImGui::GetFontSize();
}

inline constexpr float kLeftPanelEm = 20;
inline constexpr float kRightPanelEm = 17;
inline constexpr float kPictureEm = 20;  // at least, between both

/// Fonts, colours and spacing for this scale (1: 96 dots per inch). Between frames only.
/// Falls back to ImGui's own font, which has no Greek letters, where DejaVu Sans is not installed.
void apply_theme(float scale);

/// For headings: larger, Latin letters alone.
ImFont* title_font();

namespace theme {
inline const ImVec4 kText{0.90f, 0.91f, 0.92f, 1.0f};
inline const ImVec4 kFaint{0.62f, 0.64f, 0.67f, 1.0f};
inline const ImVec4 kAccent{0.33f, 0.58f, 0.88f, 1.0f};
inline const ImVec4 kGood{0.45f, 0.80f, 0.50f, 1.0f};
inline const ImVec4 kBusy{0.95f, 0.74f, 0.32f, 1.0f};
inline const ImVec4 kBad{0.96f, 0.46f, 0.42f, 1.0f};
inline const ImVec4 kPanel{0.145f, 0.155f, 0.170f, 1.0f};
}  // namespace theme

inline ImVec4 to_imgui(const Vec3f& colour, float opacity = 1) {
  return {colour.x(), colour.y(), colour.z(), opacity};
}

/// Text that is less important.
void faint_text(const char* format, ...) IM_FMTARGS(1);

/// Shows a hint while the last item is under the mouse.
void hint(const char* text);

}  // namespace burnish
