#include "client/app/panels/strength_pictures.h"

#include <cmath>
#include <cstdio>
#include <imgui.h>
#include <optional>
#include <string>

#include "client/app/widgets/places.h"
#include "client/app/widgets/theme.h"

namespace burnish {
namespace {

ImTextureID texture_of(const GlImage& image) {
  return reinterpret_cast<ImTextureID>(uintptr_t{image.texture()});
}

std::string strength_text(double strength) {
  char text[16];
  std::snprintf(text, sizeof text, "%.2f", strength);
  return text;
}

// A tooltip shows the picture as large as it was made.
void draw_hint(const StrengthStrip::Picture& picture, const GlImage* image) {
  if (!ImGui::IsItemHovered()) return;
  ImGui::BeginTooltip();
  if (image) {
    const float width = em(18);
    const ImageSize& size = picture.image.size;
    ImGui::Image(texture_of(*image),
                 {width, width * static_cast<float>(size.height) / static_cast<float>(size.width)});
  }
  ImGui::Text("Strength %.2f, %s of the preset", picture.strength,
              std::string(strength_word(picture.strength)).c_str());
  ImGui::EndTooltip();
}

// Returns whether the user chooses it. Needs: an id of its own is pushed, as texts may be equal.
bool draw_picture(const StrengthStrip::Picture& picture, const GlImage* image, float width,
                  bool is_in_force) {
  const std::string text = strength_text(picture.strength);
  const float height = width * static_cast<float>(kStrengthPictureSize.height) /
                       static_cast<float>(kStrengthPictureSize.width);
  const ImVec2 low = ImGui::GetCursorScreenPos();
  const float line = ImGui::GetTextLineHeight();
  const bool is_chosen = ImGui::InvisibleButton("picture", {width, height + line});
  note_place((image ? "Strength " : "Waits for strength ") + text);
  ImDrawList* const list = ImGui::GetWindowDrawList();
  const ImVec2 high{low.x + width, low.y + height};
  const float rounding = em(0.3f);
  if (image) {
    list->AddImageRounded(texture_of(*image), low, high, {0, 0}, {1, 1}, IM_COL32_WHITE, rounding);
  } else {
    list->AddRectFilled(low, high, ImGui::GetColorU32(ImGuiCol_FrameBg), rounding);
  }
  const bool is_marked = is_in_force || ImGui::IsItemHovered() || ImGui::IsItemFocused();
  if (is_marked)
    list->AddRect(low, high,
                  is_in_force ? ImGui::ColorConvertFloat4ToU32(theme::kAccent)
                              : ImGui::GetColorU32(ImGuiCol_TextDisabled),
                  rounding, 0, em(0.15f));
  const float text_width = ImGui::CalcTextSize(text.c_str()).x;
  list->AddText({low.x + (width - text_width) / 2, high.y},
                ImGui::GetColorU32(is_in_force ? ImGuiCol_Text : ImGuiCol_TextDisabled),
                text.c_str());
  draw_hint(picture, image);
  return is_chosen;
}

}  // namespace

const GlImage* StrengthPictures::image_of(const StrengthStrip::Picture& picture, size_t place) {
  Held& held = held_[place];
  if (held.number != picture.number)
    held = {picture.number,
            picture.number > 0 ? std::make_unique<GlImage>(picture.image) : nullptr};
  return held.image.get();
}

void StrengthPictures::draw(Workspace& workspace, const PresetInForce& shown) {
  Document& document = *workspace.document();
  StrengthStrip& strip = workspace.strip;
  if (document.is_viewer() || !Document::has_trial(shown.preset)) return strip.close(&document);
  if (strip.is_open() && strip.preset() != shown.preset.name) strip.close(&document);
  const bool is_open = strip.is_open();
  draw_button(workspace, shown);
  if (is_open && strip.is_open()) draw_row(workspace, shown);
}

void StrengthPictures::draw_button(Workspace& workspace, const PresetInForce& shown) {
  StrengthStrip& strip = workspace.strip;
  const bool is_open = strip.is_open();
  const char* const label = is_open ? "Close the pictures" : "Compare strengths";
  ImGui::BeginDisabled(!is_open && !(shown.strength > 0));
  const bool is_pressed = noted(label, ImGui::Button(label, {-1, 0}));
  ImGui::EndDisabled();
  if (!is_open)
    hint(
        "Shows a weaker and a stronger filter for a moment, to everybody in the session, and keeps "
        "small pictures of what you look at, to choose from");
  if (!is_pressed) return;
  if (is_open) return strip.close(workspace.document());
  const Status opened = strip.open(shown, *workspace.document());
  if (!opened.is_ok()) workspace.log.failure("strengths", opened);
}

void StrengthPictures::draw_row(Workspace& workspace, const PresetInForce& shown) {
  StrengthStrip& strip = workspace.strip;
  const float gap = ImGui::GetStyle().ItemSpacing.x;
  const float width = (ImGui::GetContentRegionAvail().x - 2 * gap) / 3;
  std::optional<int> chosen;
  for (size_t i = 0; i < strip.pictures().size(); ++i) {
    const StrengthStrip::Picture& picture = strip.pictures()[i];
    if (i > 0) ImGui::SameLine();
    const bool is_in_force = std::abs(picture.strength - shown.strength) < 1e-5;
    ImGui::PushID(static_cast<int>(i));
    if (draw_picture(picture, image_of(picture, i), width, is_in_force))
      chosen = static_cast<int>(i);
    ImGui::PopID();
  }
  if (!chosen) return;
  const Status done = strip.choose(*chosen, *workspace.document());
  if (!done.is_ok()) workspace.log.failure("strengths", done);
}

}  // namespace burnish
