#include "client/app/start/start_page.h"

#include <algorithm>
#include <filesystem>
#include <imgui.h>
#include <imgui_stdlib.h>
#include <optional>
#include <utility>

#include "client/app/widgets/places.h"
#include "client/app/widgets/theme.h"
#include "client/app/widgets/words.h"
#include "client/model/files/typed_path.h"
#include "common/mesh/mesh_format.h"

namespace burnish {

// ---- The lists of scans and sessions ----

static std::string scan_name(const Library& library, const std::string& id) {
  for (const ScanInfo& scan : library.scans)
    if (scan.id == id) return scan.name;
  return short_id(id);
}

static size_t sessions_of(const Library& library, const std::string& scan) {
  return static_cast<size_t>(
      std::count_if(library.sessions.begin(), library.sessions.end(),
                    [&](const SessionInfo& session) { return session.scan_id == scan; }));
}

static constexpr float kWideListEm = 40;
static constexpr ImGuiTableFlags kTable =
    ImGuiTableFlags_RowBg | ImGuiTableFlags_BordersInnerH | ImGuiTableFlags_SizingStretchProp;

// A column that is less important is left out where there is little room.
static void add_column(const char* name, float width_em, bool is_shown = true) {
  const auto hidden = is_shown ? ImGuiTableColumnFlags_None : ImGuiTableColumnFlags_Disabled;
  ImGui::TableSetupColumn(name, ImGuiTableColumnFlags_WidthFixed | hidden, em(width_em));
}

// Draws a button that asks first. Returns true if the user is sure.
static bool draw_delete(const std::string& question) {
  if (ImGui::SmallButton("Delete")) ImGui::OpenPopup("##sure");
  hint("Deletes it from the server, after a question.");
  if (!ImGui::BeginPopup("##sure")) return false;
  ImGui::TextUnformatted(question.c_str());
  const bool is_sure = ImGui::Button("Delete for good");
  if (is_sure) ImGui::CloseCurrentPopup();
  ImGui::EndPopup();
  return is_sure;
}

// Draws a button that asks for a name. Returns the name when the user is done.
static std::optional<std::string> draw_rename(const std::string& name) {
  static std::string typed;  // one popup is open at a time
  if (ImGui::SmallButton("Rename")) {
    typed = name;
    ImGui::OpenPopup("##rename");
  }
  hint("Gives it another name. Its edits stay.");
  if (!ImGui::BeginPopup("##rename")) return std::nullopt;
  if (ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
  ImGui::SetNextItemWidth(em(16));
  const bool entered = ImGui::InputText(
      "##name", &typed, ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
  ImGui::SameLine();
  const bool is_done = (ImGui::Button("Rename") || entered) && !typed.empty();
  if (is_done) ImGui::CloseCurrentPopup();
  ImGui::EndPopup();
  return is_done && typed != name ? std::optional(typed) : std::nullopt;
}

static std::string question_of(const ScanInfo& scan, size_t sessions) {
  if (sessions == 0) return "The server deletes " + scan.name + ".";
  return "The server deletes " + scan.name + ", and " + std::to_string(sessions) +
         (sessions == 1 ? " session with its edits." : " sessions with their edits.");
}

static void draw_scan(const ScanInfo& scan, Workspace& workspace) {
  const size_t sessions = sessions_of(workspace.library(), scan.id);
  ImGui::TableNextColumn();
  const std::string shown = cut_to(scan.name, ImGui::GetContentRegionAvail().x);
  if (ImGui::Selectable(shown.c_str())) workspace.open_scan(scan, Opening::kGoOn);
  const char* const what = sessions == 0 ? "Opens it." : "Goes on where you left it.";
  hint((shown == scan.name ? what : scan.name + "\n" + what).c_str());
  ImGui::TableNextColumn();
  faint_text("%s", counted(scan.statistics.triangles).c_str());
  ImGui::TableNextColumn();
  faint_text("%s", scan.statistics.is_closed() ? "closed" : "open");
  ImGui::TableNextColumn();
  faint_text("%s", megabytes(bytes_on_disk(scan)).c_str());
  ImGui::TableNextColumn();
  faint_text("%s", day_of(scan.imported_unix_seconds).c_str());
  ImGui::TableNextColumn();
  if (ImGui::SmallButton("New")) workspace.open_scan(scan, Opening::kAnew);
  hint("Opens it in a new session.");
  ImGui::SameLine();
  if (const auto name = draw_rename(scan.name)) workspace.rename_scan(scan.id, *name);
  ImGui::SameLine();
  if (draw_delete(question_of(scan, sessions))) workspace.delete_scan(scan.id);
}

// Lists the server's scans; a click opens one in a new session.
static void draw_scans(Workspace& workspace) {
  const Library& library = workspace.library();
  uint64_t bytes = 0;
  for (const ScanInfo& scan : library.scans) bytes += bytes_on_disk(scan);
  ImGui::TextUnformatted("Scans");
  if (library.scans.empty()) return faint_text("none yet");
  ImGui::SameLine();
  faint_text("%s on disk", megabytes(bytes).c_str());
  const bool has_room = ImGui::GetContentRegionAvail().x > em(kWideListEm);
  if (!ImGui::BeginTable("##scans", 6, kTable)) return;
  ImGui::TableSetupColumn("name", 0, 1);
  add_column("triangles", 5);
  add_column("surface", 4, has_room);
  add_column("on disk", 4.5f);
  add_column("imported", 6, has_room);
  add_column("", 12.6f);
  ImGui::TableHeadersRow();
  for (const ScanInfo& scan : library.scans) {
    ImGui::PushID(scan.id.c_str());
    draw_scan(scan, workspace);
    ImGui::PopID();
  }
  ImGui::EndTable();
}

static void draw_session(const SessionInfo& session, Workspace& workspace) {
  ImGui::TableNextColumn();
  const std::string shown = cut_to(session.name, ImGui::GetContentRegionAvail().x);
  if (ImGui::Selectable(shown.c_str())) workspace.join(session);
  hint(shown == session.name ? "Goes on with it." : session.name.c_str());
  ImGui::TableNextColumn();
  const std::string scan = scan_name(workspace.library(), session.scan_id);
  faint_text("%s", cut_to(scan, ImGui::GetContentRegionAvail().x).c_str());
  ImGui::TableNextColumn();
  faint_text("%llu", static_cast<unsigned long long>(session.edits));
  ImGui::TableNextColumn();
  faint_text("%d", session.key.depth);
  ImGui::TableNextColumn();
  faint_text("%s", day_of(session.created_unix_seconds).c_str());
  ImGui::TableNextColumn();
  if (const auto name = draw_rename(session.name)) workspace.rename_session(session, *name);
  ImGui::SameLine();
  if (draw_delete("The server deletes " + session.name + " with " + std::to_string(session.edits) +
                  (session.edits == 1 ? " edit." : " edits.")))
    workspace.delete_session(session);
}

// Lists the server's sessions; a click joins one.
static void draw_sessions(Workspace& workspace) {
  ImGui::TextUnformatted("Sessions");
  const Library& library = workspace.library();
  if (library.sessions.empty()) return faint_text("none yet");
  const bool has_room = ImGui::GetContentRegionAvail().x > em(kWideListEm);
  if (!ImGui::BeginTable("##sessions", 6, kTable)) return;
  ImGui::TableSetupColumn("name", 0, 1);
  ImGui::TableSetupColumn("scan", 0, 1);
  add_column("edits", 3.5f);
  add_column("depth", 3.5f, has_room);
  add_column("begun", 6, has_room);
  add_column("", 9);
  ImGui::TableHeadersRow();
  for (const SessionInfo& session : library.sessions) {
    ImGui::PushID(session.id.c_str());
    draw_session(session, workspace);
    ImGui::PopID();
  }
  ImGui::EndTable();
}

// ---- The page ----

static constexpr float kSideBySideEm = 56;              // least width of two columns
static constexpr float kOpenEm = 17.5f, kListsEm = 30;  // heights in one column, which scrolls

static void draw_state(const Library& library) {
  const char* const where = library.is_private ? "this computer" : library.server.c_str();
  switch (library.state) {
    case Library::State::kUnconnected:
      faint_text("not connected");
      break;
    case Library::State::kConnecting:
      ImGui::TextColored(theme::kBusy, "connecting to %s…", where);
      break;
    case Library::State::kConnected:
      ImGui::TextColored(theme::kGood, "connected to %s", where);
      break;
    case Library::State::kFailed:
      ImGui::PushStyleColor(ImGuiCol_Text, theme::kBad);
      ImGui::TextWrapped("%s", library.problem.c_str());
      ImGui::PopStyleColor();
      break;
  }
}

void StartPage::draw_open(Workspace& workspace) {
  for (const ImGuiCol each : {ImGuiCol_Button, ImGuiCol_ButtonHovered, ImGuiCol_ButtonActive})
    ImGui::PushStyleColor(each, theme::kStrong);
  ImGui::PushStyleColor(ImGuiCol_Text, theme::kOnStrong);
  ImGui::PushFont(title_font());
  if (noted("Open a scan", ImGui::Button("Open a scan…", {-1, em(4)}))) wants_to_open_ = true;
  ImGui::PopFont();
  ImGui::PopStyleColor(4);
  hint(("Chooses a mesh file: " + extensions_text() + " (Ctrl+O).").c_str());
  faint_text("or drop a file on the window, or type its path");
  ImGui::SetNextItemWidth(-em(5));
  const bool entered = ImGui::InputTextWithHint("##file", "~/scans/head.ply", &file_,
                                                ImGuiInputTextFlags_EnterReturnsTrue);
  note_place("Path");
  hint("The path of a mesh file; ~ is your home folder.");
  ImGui::SameLine();
  if ((ImGui::Button("Open", {-1, 0}) || entered) && !file_.empty())
    workspace.import_scan(typed_path(file_));
}

void StartPage::draw_server(Workspace& workspace) {
  ImGui::TextUnformatted("Server");
  const float half = (ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ItemSpacing.x) / 2;
  if (ImGui::Button("Use this computer", {half, 0})) workspace.connect_privately();
  hint("Starts your own server, which keeps its scans in your home folder.");
  ImGui::SameLine();
  if (noted("Another server", ImGui::Button("Another server…", {half, 0})))
    connection_dialog_.open();
  hint("Connects to a server that others may use too.");
  draw_state(workspace.library());
}

void StartPage::draw(Workspace& workspace) {
  const float width = ImGui::GetContentRegionAvail().x;
  const bool is_wide = width > em(kSideBySideEm);
  const float left = is_wide ? std::max(em(20), 0.34f * width) : width;
  ImGui::SetCursorPosY(em(1.2f));
  ImGui::PushFont(title_font());
  ImGui::TextUnformatted("Burnish");
  ImGui::PopFont();
  faint_text("smooths and sharpens scanned surfaces");
  ImGui::Dummy({0, em(0.6f)});
  ImGui::BeginChild("##left", {left, is_wide ? 0 : em(kOpenEm)});
  draw_open(workspace);
  ImGui::Dummy({0, em(0.8f)});
  draw_server(workspace);
  note_window("Open and server");
  ImGui::EndChild();
  if (is_wide) ImGui::SameLine(0, em(1.6f));
  ImGui::BeginChild("##right", {0, is_wide ? 0 : em(kListsEm)});
  ImGui::TextUnformatted("Recent");
  cards_.draw(workspace);
  ImGui::Dummy({0, em(0.8f)});
  draw_scans(workspace);
  ImGui::Dummy({0, em(0.8f)});
  draw_sessions(workspace);
  note_window("Lists");
  ImGui::EndChild();
  connection_dialog_.draw(workspace);
}

}  // namespace burnish
