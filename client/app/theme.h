#pragma once

#include <imgui.h>

#include "common/base/types.h"

namespace burnish {

/// Converts from em, the font's height: one number scales all sizes.
inline float em(float count) {
  return count * ImGui::GetFontSize();
}

inline constexpr float kLeftPanelEm = 20;
inline constexpr float kRightPanelEm = 17;
inline constexpr float kPictureEm = 20;  // least width between both columns

/// Sets fonts, colours and spacing for this scale (1: 96 dots per inch). Call it between frames.
/// Without DejaVu Sans it uses ImGui's own font, which has no Greek letters.
void apply_theme(float scale);

/// Returns the font for headings: larger, only Latin letters.
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

/// Draws text that is less important.
void faint_text(const char* format, ...) IM_FMTARGS(1);

/// Shows a hint while the last item is under the mouse.
void hint(const char* text);

}  // namespace burnish
