#include "client/app/hud.h"

#include <cstdarg>

#include "client/app/places.h"
#include "client/app/theme.h"

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
  if (document.stats().frames == 0) return {"waiting for the first frame", theme::kBusy};
  if (!document.stats().frame.settled) return {"converging", theme::kBusy};
  if (!document.is_settled()) return {"saving", theme::kBusy};
  return {document.stats().frame.exact ? "exact" : "settled", theme::kGood};
}

void row(const char* name, const char* format, ...) IM_FMTARGS(2);

void row(const char* name, const char* format, ...) {
  faint_text("%s", name);
  ImGui::SameLine(em(7.5f));
  va_list arguments;
  va_start(arguments, format);
  ImGui::TextV(format, arguments);
  va_end(arguments);
}

void draw_stats(const Document& document) {
  const LinkStats& stats = document.stats();
  row("residual", "%.1e", stats.frame.residual);
  row("distance", "%.1e of the diagonal", stats.frame.distance);
  row("cycles", "%d (%s)", stats.frame.cycles, document.welcome().backend.c_str());
  row("server", "%.1f + %.1f + %.1f ms", stats.frame.assemble_ms, stats.frame.solve_ms,
      stats.frame.encode_ms);
  hint("Time to assemble, solve and encode the last frame.");
  row("frame age", "%.0f ms", stats.age_ms);
  row("round trip", "%.1f ms", stats.rtt_ms);
  row("frames", "%.0f/s, %.1f Mbit/s", stats.frames_per_second, stats.megabits_per_second);
  if (document.shown_after_ms() > 0) row("edit to picture", "%.0f ms", document.shown_after_ms());
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
  if (shows_figures && has_room && document.stats().frames > 0) draw_stats(document);
  if (workspace.viewport.navigate_mode) faint_text("left button turns the view (N)");
  note_window("Figures over the picture");
  ImGui::End();
}

}  // namespace burnish
