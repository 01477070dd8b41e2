#include "client/app/overlay/hud.h"

#include "client/app/widgets/places.h"
#include "client/app/widgets/theme.h"
#include "client/app/widgets/words.h"
#include "client/model/documents/figures.h"

namespace burnish {
namespace {

struct Chip {
  const char* text;
  ImVec4 colour;
};

Chip chip_of(const Document& document) {
  switch (document.link()) {
    case LinkState::kConnecting:
      return {"connecting", theme::kBusy};
    case LinkState::kLost:
      return {"connection lost, reconnecting", theme::kBad};
    case LinkState::kEnded:
      return {"session ended", theme::kBad};
    case LinkState::kLive:
      break;
  }
  const bool is_good = document.stats().frames > 0 && document.is_settled();
  return {state_word(document), is_good ? theme::kGood : theme::kBusy};
}

void draw_stats(const Document& document) {
  for (const Figure& figure : link_figures(document)) {
    faint_text("%s", figure.name.c_str());
    ImGui::SameLine(em(7.5f));
    ImGui::TextUnformatted(figure.value.c_str());
    if (figure.name == "server") hint("Time to assemble, solve and encode the last frame.");
  }
}

}  // namespace

void FiguresPanel::draw(Workspace& workspace) {
  draw_stats(*workspace.document());
}

void Hud::draw(Workspace& workspace) {
  if (room.x < em(16) || room.y < em(12)) return;
  const bool has_room = room.x >= em(38) && room.y >= em(26);
  const Document& document = *workspace.document();
  const float margin = em(0.7f);
  ImGui::SetNextWindowPos({upper_right.x - margin, upper_right.y + margin}, 0, {1, 0});
  ImGui::SetNextWindowBgAlpha(kOverlayOpacity);
  ImGui::Begin("##hud", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoInputs |
                   ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoNav |
                   ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoSavedSettings);
  const Chip chip = chip_of(document);
  ImGui::TextColored(chip.colour, "%s", chip.text);
  const std::string simplified = text_by_picture(document.surface().status());
  if (!simplified.empty()) faint_text("%s", simplified.c_str());
  if (shows_figures && has_room && document.stats().frames > 0) draw_stats(document);
  if (workspace.viewport.navigate_mode) faint_text("left button turns the view (N)");
  note_window("Figures over the picture");
  ImGui::End();
}

}  // namespace burnish
