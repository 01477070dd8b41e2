#include "client/app/dialogs/leave_question.h"

#include <imgui.h>

#include "client/app/widgets/places.h"
#include "client/app/widgets/theme.h"

namespace burnish {

static constexpr const char* kQuestion = "Not all is saved yet";

static const char* reason(const Unsaved& unsaved, LinkState link) {
  if (unsaved.edits == 0) return "An export is under way.";
  switch (link) {
    case LinkState::kLive:
      return "The server has not answered yet.";
    case LinkState::kConnecting:
    case LinkState::kLost:
      return "The connection is lost. Edits are saved when it is back.";
    case LinkState::kEnded:
      break;
  }
  return "The session has ended. These edits cannot be saved.";
}

void draw_leave_question(const Workspace& workspace, Leaving::Step step, Leaving& leaving) {
  const bool is_waiting = step == Leaving::Step::kWait;
  const bool is_wanted = is_waiting || step == Leaving::Step::kAsk;
  if (is_wanted && !ImGui::IsPopupOpen(kQuestion)) ImGui::OpenPopup(kQuestion);
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({screen.x / 2, screen.y / 2}, ImGuiCond_Appearing, {0.5f, 0.5f});
  if (!ImGui::BeginPopupModal(kQuestion, nullptr, ImGuiWindowFlags_AlwaysAutoResize)) return;
  begin_place_group("Question");
  const LinkState link = workspace.link();
  const Unsaved unsaved = workspace.unsaved();
  ImGui::Text("%s yet.", text_of(unsaved).c_str());
  faint_text("%s", reason(unsaved, link));
  if (is_waiting) ImGui::TextColored(theme::kBusy, "Closing as soon as all is saved…");
  ImGui::Dummy({0, em(0.3f)});
  ImGui::BeginDisabled(is_waiting || (unsaved.edits > 0 && link == LinkState::kEnded));
  if (noted("Wait", ImGui::Button("Wait", {em(8), 0}))) leaving.wait();
  ImGui::EndDisabled();
  ImGui::SameLine();
  if (noted("Discard and close", ImGui::Button("Discard and close", {em(11), 0})))
    leaving.discard();
  ImGui::SameLine();
  if (ImGui::Button("Cancel", {em(8), 0})) leaving.stay();
  if (!is_wanted) ImGui::CloseCurrentPopup();
  note_window("Question");
  ImGui::EndPopup();
}

}  // namespace burnish
