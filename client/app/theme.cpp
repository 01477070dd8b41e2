#include "client/app/theme.h"

#include <cmath>
#include <cstdarg>
#include <filesystem>

namespace burnish {

static constexpr const char* kFontFile = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf";
static constexpr float kFontPixels = 14;
static constexpr float kTitlePixels = 22;

static void load_font(float scale) {
  // Latin with its extensions, Greek and Cyrillic, general punctuation, arrows, mathematical
  // operators.
  static const ImWchar kRanges[] = {0x20,   0x24f,  0x370,  0x52f,  0x1e00, 0x1eff, 0x2010,
                                    0x2044, 0x2190, 0x21ff, 0x2200, 0x22ff, 0};
  ImGuiIO& io = ImGui::GetIO();
  io.Fonts->Clear();
  std::error_code error;
  if (std::filesystem::exists(kFontFile, error)) {
    io.Fonts->AddFontFromFileTTF(kFontFile, std::round(kFontPixels * scale), nullptr, kRanges);
    io.Fonts->AddFontFromFileTTF(kFontFile, std::round(kTitlePixels * scale));
    return;
  }
  ImFontConfig config;
  config.SizePixels = std::round(13 * scale);
  io.Fonts->AddFontDefault(&config);
}

static void set_colours(ImGuiStyle& style) {
  ImGui::StyleColorsDark(&style);
  ImVec4* const colours = style.Colors;
  colours[ImGuiCol_Text] = theme::kText;
  colours[ImGuiCol_TextDisabled] = theme::kFaint;
  colours[ImGuiCol_WindowBg] = theme::kPanel;
  colours[ImGuiCol_PopupBg] = {0.12f, 0.13f, 0.14f, 0.98f};
  colours[ImGuiCol_MenuBarBg] = {0.11f, 0.12f, 0.13f, 1.0f};
  colours[ImGuiCol_Border] = {0.30f, 0.32f, 0.35f, 0.60f};
  colours[ImGuiCol_FrameBg] = {0.245f, 0.262f, 0.285f, 1.0f};
  colours[ImGuiCol_FrameBgHovered] = {0.29f, 0.31f, 0.34f, 1.0f};
  colours[ImGuiCol_FrameBgActive] = {0.32f, 0.35f, 0.39f, 1.0f};
  colours[ImGuiCol_TableHeaderBg] = {0.18f, 0.195f, 0.215f, 1.0f};
  colours[ImGuiCol_TableBorderLight] = {0.26f, 0.28f, 0.31f, 1.0f};
  colours[ImGuiCol_TitleBgActive] = {0.21f, 0.25f, 0.30f, 1.0f};
  colours[ImGuiCol_Header] = {0.21f, 0.25f, 0.30f, 1.0f};
  colours[ImGuiCol_HeaderHovered] = {0.26f, 0.33f, 0.42f, 1.0f};
  colours[ImGuiCol_HeaderActive] = {0.28f, 0.38f, 0.50f, 1.0f};
  colours[ImGuiCol_Button] = {0.25f, 0.31f, 0.38f, 1.0f};
  colours[ImGuiCol_ButtonHovered] = {0.29f, 0.41f, 0.55f, 1.0f};
  colours[ImGuiCol_ButtonActive] = theme::kAccent;
  colours[ImGuiCol_CheckMark] = theme::kAccent;
  colours[ImGuiCol_SliderGrab] = theme::kAccent;
  colours[ImGuiCol_SliderGrabActive] = {0.50f, 0.72f, 0.98f, 1.0f};
  colours[ImGuiCol_PlotHistogram] = theme::kAccent;
  colours[ImGuiCol_ModalWindowDimBg] = {0.05f, 0.05f, 0.06f, 0.55f};
}

void apply_theme(float scale) {
  load_font(scale);
  ImGuiStyle& style = ImGui::GetStyle();
  style = ImGuiStyle();
  set_colours(style);
  style.WindowRounding = 0;
  style.ChildRounding = style.FrameRounding = style.GrabRounding = style.PopupRounding = 3;
  style.WindowBorderSize = 0;
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
