#include "client/app/dialogs/connection_dialog.h"

#include <imgui.h>
#include <imgui_stdlib.h>
#include <utility>

#include "client/app/widgets/escape.h"
#include "client/app/widgets/places.h"
#include "client/app/widgets/theme.h"
#include "client/app/widgets/words.h"

namespace burnish {

static constexpr const char* kConnectionTitle = "Connect to a server";
static constexpr float kKnownEm = 14, kFieldsEm = 27, kHeightEm = 21, kLabelEm = 7;

void ConnectionDialog::draw(Workspace& workspace) {
  if (std::exchange(opening_, false)) {
    const auto& known = workspace.preferences.servers;
    if (form_.host.empty() && !known.empty()) form_ = form_of(known.front());
    problems_ = {};
    asked_.clear();
    ImGui::OpenPopup(kConnectionTitle);
  }
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({screen.x / 2, screen.y / 2}, ImGuiCond_Always, {0.5f, 0.5f});
  constexpr auto kFlags = ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoSavedSettings;
  if (!ImGui::BeginPopupModal(kConnectionTitle, nullptr, kFlags)) return;
  begin_place_group("Connect");
  ImGui::BeginChild("##known", {em(kKnownEm), em(kHeightEm)}, true);
  draw_known(workspace);
  note_window("Known servers");
  ImGui::EndChild();
  ImGui::SameLine();
  ImGui::BeginChild("##fields", {em(kFieldsEm), em(kHeightEm)});
  draw_fields();
  draw_state(workspace.library());
  note_window("Server");
  ImGui::EndChild();
  if (noted("Connect", ImGui::Button("Connect", {em(8), 0})) || std::exchange(is_entered_, false))
    connect(workspace);
  ImGui::SameLine();
  const Library& library = workspace.library();
  const bool is_connected = library.server == asked_ && library.state == Library::State::kConnected;
  const bool is_over = ImGui::Button("Cancel", {em(8), 0}) || is_connected || is_escaped();
  if (is_over) ImGui::CloseCurrentPopup();
  note_window("Connect");
  ImGui::EndPopup();
}

void ConnectionDialog::draw_known(Workspace& workspace) {
  auto& known = workspace.preferences.servers;
  if (known.empty()) faint_text("no servers yet");
  const KnownServer* forgotten = nullptr;
  for (const KnownServer& server : known) {
    ImGui::PushID(server.address.c_str());
    const std::string shown = cut_to(server.address, em(kKnownEm - 4));
    if (ImGui::Selectable(shown.c_str(), false, 0, {em(kKnownEm - 4), 0})) form_ = form_of(server);
    hint(server.address.c_str());
    ImGui::SameLine();
    if (ImGui::SmallButton("×")) forgotten = &server;
    hint("Forgets this server and its token.");
    ImGui::PopID();
  }
  if (forgotten) known.erase(known.begin() + (forgotten - known.data()));
}

// Draws a field with its label and its problem. Returns true at Enter.
static bool draw_row(const char* label, std::string& text, const std::string& problem,
                     const char* what, ImGuiInputTextFlags flags = 0) {
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(label);
  ImGui::SameLine(em(kLabelEm));
  ImGui::SetNextItemWidth(-1);
  ImGui::PushID(label);
  const bool is_entered = ImGui::InputText(
      "##field", &text,
      ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll | flags);
  note_place(label);
  hint(what);
  ImGui::PopID();
  if (problem.empty()) return is_entered;
  ImGui::Dummy({0, 0});
  ImGui::SameLine(em(kLabelEm));
  ImGui::PushStyleColor(ImGuiCol_Text, theme::kBad);
  ImGui::TextWrapped("%s", problem.c_str());
  ImGui::PopStyleColor();
  return is_entered;
}

void ConnectionDialog::draw_fields() {
  if (ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
  is_entered_ |= draw_row("Host", form_.host, problems_.host, "A name or an address.");
  is_entered_ |= draw_row("Port", form_.port, problems_.port, "burnish-server listens on 7411.");
  ImGui::Dummy({0, 0});
  ImGui::SameLine(em(kLabelEm));
  ImGui::Checkbox("Encrypted (TLS)", &form_.tls);
  note_place("Encrypted");
  hint("The server proves who it is by a certificate.");
  is_entered_ |= draw_row("Certificate", form_.ca, problems_.ca,
                          "File (PEM) with the CA of the server. Empty: the system's CAs.");
  is_entered_ |= draw_row("User", form_.user, "", "Your name, where the token does not tell it.");
  is_entered_ |=
      draw_row("Token", form_.token, problems_.token,
               "The secret that the keeper of the server gave you.", ImGuiInputTextFlags_Password);
  ImGui::Dummy({0, 0});
  ImGui::SameLine(em(kLabelEm));
  ImGui::Checkbox("Keep the token on this computer", &form_.keeps_token);
  note_place("Keep the token");
  hint("It is kept in a file that only you can read. Otherwise it is forgotten at the end.");
}

void ConnectionDialog::draw_state(const Library& library) const {
  if (asked_.empty() || library.server != asked_) return;
  const bool has_failed = library.state == Library::State::kFailed;
  ImGui::PushStyleColor(ImGuiCol_Text, has_failed ? theme::kBad : theme::kBusy);
  ImGui::TextWrapped("%s", has_failed ? library.problem.c_str() : "connecting…");
  if (has_failed) note_place("Problem");
  ImGui::PopStyleColor();
}

void ConnectionDialog::connect(Workspace& workspace) {
  problems_ = problems_of(form_);
  if (!problems_.has_none()) return;
  const KnownServer server = server_of(form_);
  asked_ = server.address;
  workspace.connect(server);
}

}  // namespace burnish
