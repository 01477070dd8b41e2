#include "client/app/widgets/theme.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace burnish {
namespace {

constexpr double kContrastMin = 4.5;  // of WCAG 2.1, AA

double linear(float part) {
  return part <= 0.04045f ? part / 12.92 : std::pow((part + 0.055) / 1.055, 2.4);
}

double luminance(const ImVec4& colour) {
  return 0.2126 * linear(colour.x) + 0.7152 * linear(colour.y) + 0.0722 * linear(colour.z);
}

double contrast(const ImVec4& one, const ImVec4& other) {
  const double a = luminance(one), b = luminance(other);
  return (std::max(a, b) + 0.05) / (std::min(a, b) + 0.05);
}

class ThemeTest : public testing::TestWithParam<bool> {
 protected:
  ThemeTest() {
    ImGui::CreateContext();
    apply_theme(1, GetParam());
  }
  ~ThemeTest() override { ImGui::DestroyContext(); }

  static void expect_readable(const ImVec4& text, const std::vector<ImGuiCol>& grounds) {
    for (const ImGuiCol ground : grounds)
      EXPECT_GE(contrast(text, ImGui::GetStyle().Colors[ground]), kContrastMin)
          << ImGui::GetStyleColorName(ground);
  }
};

TEST(Contrast, OfBlackOnWhiteIsTwentyOne) {
  EXPECT_NEAR(contrast({0, 0, 0, 1}, {1, 1, 1, 1}), 21, 1e-9);
}

TEST_P(ThemeTest, TextIsReadableOnAllThatItLiesOn) {
  expect_readable(
      theme::kText,
      {ImGuiCol_WindowBg, ImGuiCol_PopupBg, ImGuiCol_MenuBarBg, ImGuiCol_FrameBg,
       ImGuiCol_FrameBgHovered, ImGuiCol_FrameBgActive, ImGuiCol_TitleBgActive,
       ImGuiCol_TableHeaderBg, ImGuiCol_Header, ImGuiCol_HeaderHovered, ImGuiCol_HeaderActive,
       ImGuiCol_Button, ImGuiCol_ButtonHovered, ImGuiCol_ButtonActive, ImGuiCol_PlotHistogram});
}

// Hints lie in fields, the keys of actions in menus.
TEST_P(ThemeTest, FaintTextIsReadable) {
  expect_readable(theme::kFaint, {ImGuiCol_WindowBg, ImGuiCol_PopupBg, ImGuiCol_MenuBarBg,
                                  ImGuiCol_FrameBg, ImGuiCol_FrameBgHovered, ImGuiCol_TableHeaderBg,
                                  ImGuiCol_Header, ImGuiCol_HeaderHovered});
}

TEST_P(ThemeTest, ColouredTextIsReadable) {
  for (const ImVec4& text : {theme::kGood, theme::kBusy, theme::kBad, theme::kAccent})
    expect_readable(text, {ImGuiCol_WindowBg, ImGuiCol_PopupBg});
  EXPECT_GE(contrast(theme::kOnStrong, theme::kStrong), kContrastMin);
}

// The picture behind is light in both themes.
TEST_P(ThemeTest, TextOverThePictureIsReadable) {
  const auto mixed = [](float panel) { return kOverlayOpacity * panel + 1 - kOverlayOpacity; };
  const ImVec4 ground(mixed(theme::kPanel.x), mixed(theme::kPanel.y), mixed(theme::kPanel.z), 1);
  for (const ImVec4& text : {theme::kText, theme::kFaint, theme::kGood, theme::kBusy, theme::kBad})
    EXPECT_GE(contrast(text, ground), kContrastMin);
}

INSTANTIATE_TEST_SUITE_P(Colours, ThemeTest, testing::Bool(),
                         [](const auto& light) { return light.param ? "light" : "dark"; });

}  // namespace
}  // namespace burnish
