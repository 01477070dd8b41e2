#include <algorithm>
#include <ctime>
#include <imgui.h>
#include <imgui_stdlib.h>
#include <set>
#include <string>

#include "client/app/panels/panels.h"
#include "client/app/widgets/places.h"
#include "client/app/widgets/theme.h"
#include "client/model/documents/undo_words.h"
#include "client/report/entry_text.h"

namespace burnish {

static float half_width() {
  return (ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ItemSpacing.x) / 2;
}

void HistoryPanel::draw_buttons(Document& document) {
  const ImVec2 half{half_width(), 0};
  if (noted("Undo", ImGui::Button("Undo", half))) document.undo();
  hint(undo_hint(document).c_str());
  ImGui::SameLine();
  if (ImGui::Button("Redo", half)) document.redo();
  hint(redo_hint(document).c_str());
}

static bool has_checkpoint(const Document& document, const std::string& name) {
  const auto& history = document.history();
  return std::any_of(history.begin(), history.end(), [&](const HistoryEntry& entry) {
    return entry.kind == EditKind::kSetCheckpoint && entry.summary == name;
  });
}

static void set_checkpoint(Workspace& workspace, const std::string& name) {
  Document& document = *workspace.document();
  if (has_checkpoint(document, name))
    return workspace.log.warning("checkpoint " + name + " is there already; choose another name");
  document.set_checkpoint(name);
}

void HistoryPanel::draw_checkpoint_row(Workspace& workspace) {
  const ImVec2 half{half_width(), 0};
  ImGui::SetNextItemWidth(-1);
  ImGui::InputTextWithHint("##checkpoint", "name of a checkpoint or fork", &checkpoint_name_);
  note_place("Name");
  hint("A checkpoint needs a name. A fork without one gets a name from the server.");
  ImGui::BeginDisabled(checkpoint_name_.empty() || workspace.document()->is_viewer());
  if (noted("Checkpoint", ImGui::Button("Checkpoint", half))) {
    set_checkpoint(workspace, checkpoint_name_);
    checkpoint_name_.clear();
  }
  hint("Gives the current state a name, so that you can come back to it.");
  ImGui::EndDisabled();
  ImGui::SameLine();
  if (noted("Fork", ImGui::Button("Fork", half))) {
    workspace.fork(checkpoint_name_, "");
    checkpoint_name_.clear();
  }
  hint("Opens a new session with all edits of this session.");
}

// The name of a checkpoint means its last use.
static void draw_checkpoint(const HistoryEntry& entry, Document& document, bool is_last) {
  if (!is_last) return faint_text("%s, set again later", entry.summary.c_str());
  ImGui::BeginDisabled(document.is_viewer());
  if (noted("Restore " + std::to_string(entry.number), ImGui::SmallButton("Restore")))
    document.restore_checkpoint(entry.summary);
  hint("Goes back to this state. The edits after it are switched off.");
  ImGui::EndDisabled();
  ImGui::SameLine();
  ImGui::TextColored(theme::kAccent, "%s", entry.summary.c_str());
}

static std::string all_of(const HistoryEntry& entry, const std::string& unit) {
  char time[32];
  const time_t seconds = entry.unix_ms / 1000;
  std::tm local{};
  localtime_r(&seconds, &local);
  std::strftime(time, sizeof time, "%F %T", &local);
  const std::string details = entry_details(entry, unit);
  return entry_name(entry) + "\n" + (details.empty() ? details : details + "\n") + time + "\nby " +
         (entry.author.empty() ? "somebody" : entry.author) + ", number " +
         std::to_string(entry.number);
}

static void draw_entry(const HistoryEntry& entry, Document& document,
                       std::set<std::string>& checkpoints) {
  ImGui::PushID(static_cast<int>(entry.number));
  if (entry.kind == EditKind::kSetCheckpoint) {
    draw_checkpoint(entry, document, checkpoints.insert(entry.summary).second);
  } else {
    bool is_on = entry.enabled;
    ImGui::BeginDisabled(entry.kind == EditKind::kDamaged);
    const bool is_switched = ImGui::Checkbox("##on", &is_on);
    note_place("Entry " + std::to_string(entry.number));
    if (is_switched && !document.is_viewer()) document.switch_entry(entry.number, is_on);
    ImGui::EndDisabled();
    ImGui::SameLine();
    ImGui::PushStyleColor(ImGuiCol_Text, entry.enabled ? theme::kText : theme::kFaint);
    ImGui::TextWrapped("%s", entry_name(entry).c_str());
    ImGui::PopStyleColor();
  }
  if (ImGui::IsItemHovered()) hint(all_of(entry, document.unit()).c_str());
  ImGui::PopID();
}

void HistoryPanel::draw(Workspace& workspace) {
  Document& document = *workspace.document();
  ImGui::BeginDisabled(document.is_viewer());
  draw_buttons(document);
  ImGui::EndDisabled();
  ImGui::BeginChild("##entries", {0, em(12)}, true);
  std::set<std::string> checkpoints;  // above the entry
  for (auto entry = document.history().rbegin(); entry != document.history().rend(); ++entry)
    draw_entry(*entry, document, checkpoints);
  if (document.history().empty()) faint_text("no edits yet");
  note_window("Entries");
  ImGui::EndChild();
  draw_checkpoint_row(workspace);
}

}  // namespace burnish
