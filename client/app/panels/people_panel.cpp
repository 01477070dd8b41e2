#include "client/app/panels/panels.h"
#include "client/app/widgets/theme.h"
#include "client/app/widgets/words.h"
#include "client/tools/colours.h"

namespace burnish {

static void draw_role(Document& document, const PresentUser& user) {
  const SessionRole role = document.people().roles.of(user.user);
  if (document.welcome().role != SessionRole::kOwner || user.user.empty()) {
    faint_text("%s", session_role_name(role));
    return hint("Only an owner changes roles.");
  }
  ImGui::SetNextItemWidth(-1);
  const bool is_open = ImGui::BeginCombo("##role", session_role_name(role));
  if (!is_open) return hint("A viewer looks, an editor edits, an owner changes roles too.");
  for (SessionRole each : {SessionRole::kViewer, SessionRole::kEditor, SessionRole::kOwner})
    if (ImGui::Selectable(session_role_name(each), each == role))
      document.set_role(user.user, each);
  ImGui::EndCombo();
}

static void draw_person(Document& document, const PresentUser& user) {
  ImGui::PushID(static_cast<int>(user.connection));
  const ImVec4 colour = to_imgui(colour_of_hex(user.colour));
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float radius = em(0.35f);
  ImGui::GetWindowDrawList()->AddCircleFilled({at.x + radius, at.y + ImGui::GetFrameHeight() / 2},
                                              radius, ImGui::ColorConvertFloat4ToU32(colour));
  ImGui::Dummy({2 * radius, ImGui::GetFrameHeight()});
  ImGui::SameLine();
  ImGui::AlignTextToFramePadding();
  const bool is_me = user.connection == document.welcome().connection;
  const std::string name = user.user.empty() ? "guest" : user.user;
  text_with_ellipsis(is_me ? name + " (you)" : name, em(7));
  ImGui::SameLine(em(9));
  ImGui::AlignTextToFramePadding();
  draw_role(document, user);
  ImGui::PopID();
}

void PeoplePanel::draw(Workspace& workspace) {
  Document& document = *workspace.document();
  for (const PresentUser& user : document.people().present) draw_person(document, user);
  if (document.people().present.empty()) faint_text("nobody is connected");
}

}  // namespace burnish
