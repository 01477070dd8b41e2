#include "client/app/widgets/theme.h"

#include <cstdarg>

namespace burnish {

static void set_dark_colours(ImVec4* colours) {
  theme::kText = {0.90f, 0.91f, 0.92f, 1.0f};
  theme::kFaint = {0.72f, 0.74f, 0.77f, 1.0f};
  theme::kAccent = {0.45f, 0.67f, 0.95f, 1.0f};
  theme::kStrong = {0.17f, 0.38f, 0.66f, 1.0f};
  theme::kGood = {0.45f, 0.80f, 0.50f, 1.0f};
  theme::kBusy = {0.95f, 0.74f, 0.32f, 1.0f};
  theme::kBad = {0.98f, 0.55f, 0.51f, 1.0f};
  theme::kPanel = {0.145f, 0.155f, 0.170f, 1.0f};
  colours[ImGuiCol_PopupBg] = {0.12f, 0.13f, 0.14f, 0.98f};
  colours[ImGuiCol_MenuBarBg] = {0.11f, 0.12f, 0.13f, 1.0f};
  colours[ImGuiCol_Border] = {0.30f, 0.32f, 0.35f, 0.60f};
  colours[ImGuiCol_FrameBg] = {0.225f, 0.240f, 0.262f, 1.0f};
  colours[ImGuiCol_FrameBgHovered] = {0.26f, 0.28f, 0.305f, 1.0f};
  colours[ImGuiCol_FrameBgActive] = {0.28f, 0.305f, 0.34f, 1.0f};
  colours[ImGuiCol_TableHeaderBg] = {0.18f, 0.195f, 0.215f, 1.0f};
  colours[ImGuiCol_TableBorderLight] = {0.26f, 0.28f, 0.31f, 1.0f};
  colours[ImGuiCol_TitleBgActive] = {0.190f, 0.228f, 0.275f, 1.0f};
  colours[ImGuiCol_Header] = {0.190f, 0.228f, 0.275f, 1.0f};
  colours[ImGuiCol_HeaderHovered] = {0.215f, 0.275f, 0.35f, 1.0f};
  colours[ImGuiCol_HeaderActive] = {0.25f, 0.34f, 0.45f, 1.0f};
  colours[ImGuiCol_Button] = {0.230f, 0.285f, 0.350f, 1.0f};
  colours[ImGuiCol_ButtonHovered] = {0.25f, 0.36f, 0.49f, 1.0f};
  colours[ImGuiCol_ButtonActive] = colours[ImGuiCol_PlotHistogram] = theme::kStrong;
  colours[ImGuiCol_SliderGrabActive] = {0.50f, 0.72f, 0.98f, 1.0f};
  colours[ImGuiCol_ModalWindowDimBg] = {0.05f, 0.05f, 0.06f, 0.55f};
}

static void set_light_colours(ImVec4* colours) {
  theme::kText = {0.11f, 0.12f, 0.14f, 1.0f};
  theme::kFaint = {0.33f, 0.35f, 0.38f, 1.0f};
  theme::kAccent = {0.16f, 0.42f, 0.76f, 1.0f};
  theme::kStrong = theme::kAccent;
  theme::kGood = {0.06f, 0.42f, 0.16f, 1.0f};
  theme::kBusy = {0.54f, 0.32f, 0.01f, 1.0f};
  theme::kBad = {0.70f, 0.11f, 0.09f, 1.0f};
  theme::kPanel = {0.955f, 0.960f, 0.968f, 1.0f};
  colours[ImGuiCol_PopupBg] = {0.99f, 0.99f, 1.0f, 0.98f};
  colours[ImGuiCol_MenuBarBg] = {0.90f, 0.91f, 0.92f, 1.0f};
  colours[ImGuiCol_Border] = {0.62f, 0.64f, 0.67f, 0.60f};
  colours[ImGuiCol_FrameBg] = {0.860f, 0.872f, 0.888f, 1.0f};
  colours[ImGuiCol_FrameBgHovered] = {0.82f, 0.84f, 0.87f, 1.0f};
  colours[ImGuiCol_FrameBgActive] = {0.77f, 0.80f, 0.84f, 1.0f};
  colours[ImGuiCol_TableHeaderBg] = {0.88f, 0.89f, 0.91f, 1.0f};
  colours[ImGuiCol_TableBorderLight] = {0.80f, 0.81f, 0.83f, 1.0f};
  colours[ImGuiCol_TitleBgActive] = {0.80f, 0.85f, 0.92f, 1.0f};
  colours[ImGuiCol_Header] = {0.82f, 0.86f, 0.92f, 1.0f};
  colours[ImGuiCol_HeaderHovered] = {0.77f, 0.84f, 0.93f, 1.0f};
  colours[ImGuiCol_HeaderActive] = {0.66f, 0.77f, 0.92f, 1.0f};
  colours[ImGuiCol_Button] = {0.76f, 0.81f, 0.88f, 1.0f};
  colours[ImGuiCol_ButtonHovered] = {0.67f, 0.76f, 0.88f, 1.0f};
  colours[ImGuiCol_ButtonActive] = colours[ImGuiCol_PlotHistogram] = {0.56f, 0.70f, 0.90f, 1.0f};
  colours[ImGuiCol_SliderGrabActive] = {0.10f, 0.34f, 0.66f, 1.0f};
  colours[ImGuiCol_ModalWindowDimBg] = {0.30f, 0.31f, 0.33f, 0.45f};
}

// Colours that follow from others.
static void set_common_colours(ImVec4* colours) {
  colours[ImGuiCol_Text] = theme::kText;
  colours[ImGuiCol_TextDisabled] = theme::kFaint;
  colours[ImGuiCol_WindowBg] = theme::kPanel;
  colours[ImGuiCol_TitleBg] = colours[ImGuiCol_TitleBgActive];
  colours[ImGuiCol_CheckMark] = colours[ImGuiCol_SliderGrab] = theme::kAccent;
}

static void set_colours(ImGuiStyle& style, bool is_light) {
  if (is_light) {
    ImGui::StyleColorsLight(&style);
    set_light_colours(style.Colors);
  } else {
    ImGui::StyleColorsDark(&style);
    set_dark_colours(style.Colors);
  }
  set_common_colours(style.Colors);
}

void apply_theme(float scale, bool is_light) {
  ImGuiStyle& style = ImGui::GetStyle();
  style = ImGuiStyle();
  set_colours(style, is_light);
  style.WindowRounding = 0;
  style.ChildRounding = style.FrameRounding = style.GrabRounding = style.PopupRounding = 3;
  style.FramePadding = {7, 4};
  style.ItemSpacing = {7, 6};
  style.WindowPadding = {11, 10};
  style.GrabMinSize = 12;
  style.ScaleAllSizes(scale);
}

ImFont* title_font() {
  return ImGui::GetIO().Fonts->Fonts.back();
}

void faint_text(const char* format, ...) {
  va_list arguments;
  va_start(arguments, format);
  ImGui::TextColoredV(theme::kFaint, format, arguments);
  va_end(arguments);
}

void hint(const char* text) {
  if (!ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) return;
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(em(24));
  ImGui::TextUnformatted(text);
  ImGui::PopTextWrapPos();
  ImGui::EndTooltip();
}

}  // namespace burnish
