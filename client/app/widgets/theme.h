#pragma once

#include <imgui.h>

#include "common/base/types.h"

namespace burnish {

/// The font's height at a scale of 1: on a screen with 96 dots per inch.
inline constexpr float kEmPixels = 14;

/// Converts from em, the font's height: one number scales all sizes.
inline float em(float count) {
  return count * ImGui::GetFontSize();
}

inline constexpr float kLeftPanelEm = 20;
inline constexpr float kRightPanelEm = 17;
/// How much overlays on the picture cover it.
inline constexpr float kOverlayOpacity = 0.95f;
inline constexpr float kPictureEm = 20;  // least width between both columns

/// Sets colours and spacing for this scale (1: 96 dots per inch). Call it between frames.
void apply_theme(float scale, bool is_light);

/// Returns the font for headings: larger, only Latin, Greek and Cyrillic letters.
ImFont* title_font();

/// Colours of the present theme; apply_theme() sets them.
namespace theme {
inline ImVec4 kText;
inline ImVec4 kFaint;
inline ImVec4 kAccent;
inline ImVec4 kStrong;  ///< behind the text of what matters most
inline ImVec4 kGood;
inline ImVec4 kBusy;
inline ImVec4 kBad;
inline ImVec4 kPanel;
inline const ImVec4 kOnStrong{1.0f, 1.0f, 1.0f, 1.0f};
inline const ImVec4 kOnPicture{0.12f, 0.13f, 0.15f, 1.0f};  ///< text on the picture
}  // namespace theme

inline ImVec4 to_imgui(const Vec3f& colour, float opacity = 1) {
  return {colour.x(), colour.y(), colour.z(), opacity};
}

/// Draws text that is less important.
void faint_text(const char* format, ...) IM_FMTARGS(1);

/// Shows a hint while the last item is under the mouse.
void hint(const char* text);

}  // namespace burnish
