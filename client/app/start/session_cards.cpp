#include "client/app/start/session_cards.h"

#include <algorithm>

#include "client/app/widgets/places.h"
#include "client/app/widgets/theme.h"
#include "client/app/widgets/words.h"
#include "client/model/workspace/session_pictures.h"
#include "client/scene/png_reader.h"

namespace burnish {

static constexpr float kCardEm = 11.5f, kMarginEm = 0.4f;
static constexpr int kPictureSideMax = 1024;

static std::string facts_of(const RecentSession& recent) {
  if (recent.shown_unix_seconds == 0) return {};
  return day_of(recent.shown_unix_seconds) + "  " + megabytes(recent.size_bytes);
}

static std::string all_of(const RecentSession& recent) {
  std::string text = recent.session;
  if (!recent.scan_name.empty()) text += "\nscan " + recent.scan_name;
  text += "\non " + (recent.server.empty() ? "this computer" : recent.server);
  return recent.shown_unix_seconds == 0 ? text : text + "\n" + facts_of(recent);
}

static ImVec2 card_size() {
  const float picture = em(kCardEm) * kSessionPictureSize.height / kSessionPictureSize.width;
  return {em(kCardEm), picture + 2 * ImGui::GetTextLineHeight() + 3 * em(kMarginEm)};
}

// Returns true if the user clicks on the card.
static bool draw_card(const RecentSession& recent, const GlImage* picture) {
  const ImVec2 low = ImGui::GetCursorScreenPos(), size = card_size();
  const bool is_clicked = ImGui::InvisibleButton("##card", size);
  note_place("Card of " + recent.session);
  const bool is_hovered = ImGui::IsItemHovered();
  hint(all_of(recent).c_str());
  ImDrawList* const list = ImGui::GetWindowDrawList();
  const float rounding = em(0.3f), margin = em(kMarginEm), line = ImGui::GetTextLineHeight();
  const ImVec2 high{low.x + size.x, low.y + size.y};
  list->AddRectFilled(low, high,
                      ImGui::GetColorU32(is_hovered ? ImGuiCol_HeaderHovered : ImGuiCol_FrameBg),
                      rounding);
  const float text_y = high.y - 2 * line - 2 * margin;
  const ImVec2 picture_high{high.x, text_y};
  if (picture) {
    list->AddImageRounded(reinterpret_cast<ImTextureID>(uintptr_t{picture->texture()}), low,
                          picture_high, {0, 0}, {1, 1}, IM_COL32_WHITE, rounding,
                          ImDrawFlags_RoundCornersTop);
  } else {
    list->AddRectFilled(low, picture_high, ImGui::GetColorU32(ImGuiCol_Header), rounding,
                        ImDrawFlags_RoundCornersTop);
  }
  const float width = size.x - 2 * margin;
  list->AddText({low.x + margin, text_y + margin}, ImGui::GetColorU32(ImGuiCol_Text),
                cut_to(recent.session, width).c_str());
  list->AddText({low.x + margin, text_y + margin + line}, ImGui::GetColorU32(ImGuiCol_TextDisabled),
                cut_to(facts_of(recent), width).c_str());
  return is_clicked;
}

// A picture that is missing or damaged leaves its place empty.
const GlImage* SessionCards::picture_of(const std::filesystem::path& path) {
  if (path.empty()) return nullptr;
  const auto [entry, is_new] = pictures_.try_emplace(path);
  if (is_new) {
    const auto image = read_png(path, kPictureSideMax);
    if (image.is_ok()) entry->second = std::make_unique<GlImage>(*image);
  }
  return entry->second.get();
}

void SessionCards::draw(Workspace& workspace) {
  if (std::exchange(pictures_begun_, workspace.pictures_begun()) != pictures_begun_)
    pictures_.clear();
  const auto& recents = workspace.preferences.recent;
  if (recents.empty()) return faint_text("nothing opened yet");
  const float gap = ImGui::GetStyle().ItemSpacing.x;
  const float room = ImGui::GetContentRegionAvail().x;
  const auto columns = static_cast<size_t>(std::max(1.0f, (room + gap) / (em(kCardEm) + gap)));
  for (size_t i = 0; i < recents.size(); ++i) {
    if (i % columns != 0) ImGui::SameLine();
    ImGui::PushID(static_cast<int>(i));
    const bool is_chosen =
        draw_card(recents[i], picture_of(picture_path(workspace.picture_folder(), recents[i])));
    ImGui::PopID();
    if (is_chosen) return workspace.reopen(RecentSession(recents[i]));  // the list changes
  }
}

}  // namespace burnish
