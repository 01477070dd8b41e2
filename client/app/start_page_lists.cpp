#include "client/app/start_page_lists.h"

#include "client/app/theme.h"

namespace burnish {

static std::string counted(uint64_t count) {
  if (count < 10'000) return std::to_string(count);
  char text[32];
  std::snprintf(text, sizeof text, count < 10'000'000 ? "%.0f k" : "%.1f M",
                count < 10'000'000 ? count / 1e3 : count / 1e6);
  return text;
}

static std::string scan_name(const Library& library, const std::string& id) {
  for (const ScanInfo& scan : library.scans)
    if (scan.id == id) return scan.name;
  return short_id(id);
}

static constexpr ImGuiTableFlags kTable =
    ImGuiTableFlags_RowBg | ImGuiTableFlags_BordersInnerH | ImGuiTableFlags_SizingStretchProp;

static void draw_delete(const ScanInfo& scan, Workspace& workspace) {
  if (ImGui::SmallButton("Delete")) ImGui::OpenPopup("##sure");
  if (!ImGui::BeginPopup("##sure")) return;
  ImGui::Text("The server deletes %s.", scan.name.c_str());
  if (ImGui::Button("Delete for good")) {
    workspace.delete_scan(scan.id);
    ImGui::CloseCurrentPopup();
  }
  ImGui::EndPopup();
}

void draw_scans(Workspace& workspace) {
  ImGui::TextUnformatted("Scans");
  const Library& library = workspace.library();
  if (library.scans.empty()) faint_text("none yet");
  if (library.scans.empty() || !ImGui::BeginTable("##scans", 4, kTable)) return;
  ImGui::TableSetupColumn("name", 0, 1);
  ImGui::TableSetupColumn("triangles", ImGuiTableColumnFlags_WidthFixed, em(5));
  ImGui::TableSetupColumn("surface", ImGuiTableColumnFlags_WidthFixed, em(5));
  ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthFixed, em(4.5f));
  ImGui::TableHeadersRow();
  for (const ScanInfo& scan : library.scans) {
    ImGui::PushID(scan.id.c_str());
    ImGui::TableNextColumn();
    if (ImGui::Selectable(scan.name.c_str())) workspace.open({.scan = scan.id});
    hint("Opens it in a new session.");
    ImGui::TableNextColumn();
    faint_text("%s", counted(scan.statistics.triangles).c_str());
    ImGui::TableNextColumn();
    faint_text("%s", scan.statistics.is_closed() ? "closed" : "open");
    ImGui::TableNextColumn();
    draw_delete(scan, workspace);
    ImGui::PopID();
  }
  ImGui::EndTable();
}

void draw_sessions(Workspace& workspace) {
  ImGui::TextUnformatted("Sessions");
  const Library& library = workspace.library();
  if (library.sessions.empty()) faint_text("none yet");
  if (library.sessions.empty() || !ImGui::BeginTable("##sessions", 4, kTable)) return;
  ImGui::TableSetupColumn("name", 0, 1);
  ImGui::TableSetupColumn("scan", 0, 1);
  ImGui::TableSetupColumn("edits", ImGuiTableColumnFlags_WidthFixed, em(3.5f));
  ImGui::TableSetupColumn("depth", ImGuiTableColumnFlags_WidthFixed, em(4));
  ImGui::TableHeadersRow();
  for (const SessionInfo& session : library.sessions) {
    ImGui::PushID(session.id.c_str());
    ImGui::TableNextColumn();
    if (ImGui::Selectable(session.name.c_str())) workspace.join(session);
    ImGui::TableNextColumn();
    faint_text("%s", scan_name(library, session.scan_id).c_str());
    ImGui::TableNextColumn();
    faint_text("%llu", static_cast<unsigned long long>(session.edits));
    ImGui::TableNextColumn();
    faint_text("%d", session.key.depth);
    ImGui::PopID();
  }
  ImGui::EndTable();
}

}  // namespace burnish
