#include "client/app/dialogs/file_dialog.h"

#include <imgui.h>
#include <imgui_stdlib.h>
#include <utility>

#include "client/app/widgets/escape.h"
#include "client/app/widgets/places.h"
#include "client/app/widgets/theme.h"
#include "client/app/widgets/words.h"
#include "client/model/files/typed_path.h"

namespace burnish {

static constexpr float kDialogWidthEm = 56, kDialogHeightEm = 34, kPlacesEm = 12;

void FileDialog::ask(FileQuestion question, const Preferences& preferences, Take take) {
  if (is_open()) return;
  const auto folder = preferences.folders.empty() ? typed_path("~") : preferences.folders.front();
  const bool is_bare = !question.start.has_parent_path();  // a name, or nothing
  if (is_bare) question.start = question.start.empty() ? folder : folder / question.start;
  take_ = std::move(take);
  if (preferences.native_dialogs)
    if (const auto command = native_dialog(question); !command.empty()) return ask_desktop(command);
  browser_.emplace(std::move(question));
  is_new_ = true;
}

void FileDialog::ask_desktop(const std::vector<std::string>& command) {
  is_asking_natively_ = true;
  tasks_.start([this, command](const StopToken& stop) -> Tasks::Completion {
    const auto asked = ask_natively(command, stop);
    return [this, asked] {
      is_asking_natively_ = false;
      if (asked.is_ok()) answer_ = *asked;
      if (!asked.is_ok()) problem_ = asked.status().message();
    };
  });
}

void FileDialog::draw(Workspace& workspace) {
  tasks_.drain();
  if (!problem_.empty()) workspace.log.warning(std::exchange(problem_, {}));
  if (browser_) draw_browser(workspace);
  if (answer_) take(*std::exchange(answer_, std::nullopt), workspace);
}

void FileDialog::add_letters(Letters& letters) const {
  if (!browser_) return;
  letters.add(browser_->folder().native());
  for (const ListedFile& file : browser_->shown()) letters.add(file.name);
}

void FileDialog::take(const std::filesystem::path& file, Workspace& workspace) {
  remember_folder(workspace.preferences, file.parent_path());
  std::exchange(take_, nullptr)(file);
}

void FileDialog::draw_browser(Workspace& workspace) {
  const std::string title = browser_->question().title;
  if (std::exchange(is_new_, false)) ImGui::OpenPopup(title.c_str());
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({screen.x / 2, screen.y / 2}, ImGuiCond_Always, {0.5f, 0.5f});
  ImGui::SetNextWindowSize({std::min(em(kDialogWidthEm), screen.x - em(2)),
                            std::min(em(kDialogHeightEm), screen.y - em(2))});
  if (!ImGui::BeginPopupModal(title.c_str(), nullptr,
                              ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoSavedSettings))
    return browser_.reset();
  begin_place_group("Files");
  if (ImGui::Button("Up")) browser_->up();
  hint("Goes to the folder above.");
  ImGui::SameLine();
  ImGui::AlignTextToFramePadding();
  text_with_ellipsis(browser_->folder().string(), ImGui::GetContentRegionAvail().x);
  const float below = 3.2f * ImGui::GetFrameHeightWithSpacing();
  ImGui::BeginChild("##places", {em(kPlacesEm), -below}, true);
  draw_places(workspace);
  note_window("Places");
  ImGui::EndChild();
  ImGui::SameLine();
  ImGui::BeginChild("##files", {0, -below}, true);
  draw_files();
  note_window("List of files");
  ImGui::EndChild();
  draw_field();
  const bool is_over = answer_ || std::exchange(is_unwanted_, false) || is_escaped();
  if (is_over) ImGui::CloseCurrentPopup();
  note_window("Files");
  ImGui::EndPopup();
  if (is_over) browser_.reset();
}

void FileDialog::draw_places(const Workspace& workspace) {
  for (const Place& place : places_to_look(workspace.preferences.folders)) {
    const std::string shown = cut_to(place.name, ImGui::GetContentRegionAvail().x);
    ImGui::PushID(place.folder.c_str());
    if (ImGui::Selectable(shown.c_str(), place.folder == browser_->folder()))
      browser_->go(place.folder);
    hint(place.folder.c_str());
    ImGui::PopID();
  }
}

void FileDialog::draw_files() {
  const std::vector<ListedFile> files = browser_->shown();
  if (files.empty()) return faint_text("nothing here that fits");
  if (!ImGui::BeginTable("##list", 3, ImGuiTableFlags_RowBg | ImGuiTableFlags_SizingStretchProp))
    return;
  ImGui::TableSetupColumn("name", 0, 1);
  ImGui::TableSetupColumn("size", ImGuiTableColumnFlags_WidthFixed, em(5));
  ImGui::TableSetupColumn("changed", ImGuiTableColumnFlags_WidthFixed, em(6));
  ImGui::TableHeadersRow();
  const bool follows = std::exchange(follows_chosen_, false);
  std::optional<ListedFile> entered;
  for (const ListedFile& file : files) {
    ImGui::TableNextColumn();
    const std::string name = file.is_folder ? file.name + "/" : file.name;
    const std::string shown = cut_to(name, ImGui::GetContentRegionAvail().x);
    const bool is_chosen = file.name == browser_->chosen();
    ImGui::PushID(file.name.c_str());
    constexpr auto kRow =
        ImGuiSelectableFlags_SpanAllColumns | ImGuiSelectableFlags_AllowDoubleClick;
    if (ImGui::Selectable(shown.c_str(), is_chosen, kRow)) {
      browser_->choose(file);
      if (ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) entered = file;
    }
    if (shown != name) hint(name.c_str());
    if (is_chosen && follows) ImGui::SetScrollHereY();
    ImGui::PopID();
    ImGui::TableNextColumn();
    if (!file.is_folder) faint_text("%s", megabytes(file.size_bytes).c_str());
    ImGui::TableNextColumn();
    faint_text("%s", day_of(file.changed_unix_seconds).c_str());
  }
  ImGui::EndTable();
  if (!entered) return;
  if (entered->is_folder) return browser_->go(browser_->folder() / entered->name);
  answer_ = browser_->enter();
}

void FileDialog::draw_field() {
  const bool saves = browser_->question().purpose == FileQuestion::Purpose::kSave;
  std::string typed = browser_->typed();
  if (ImGui::IsWindowAppearing() || std::exchange(wants_keyboard_, false))
    ImGui::SetKeyboardFocusHere();
  ImGui::SetNextItemWidth(-1);
  bool is_done = ImGui::InputTextWithHint(
      "##typed", saves ? "name of the file" : "type to filter, or type a path; ~ is your home",
      &typed, ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
  note_place("Typed");
  browser_->type(typed);
  const bool is_active = ImGui::IsItemActive();
  for (const auto& [key, by] : {std::pair(ImGuiKey_UpArrow, -1), {ImGuiKey_DownArrow, 1}}) {
    if (!is_active || !ImGui::IsKeyPressed(ImGui::GetKeyIndex(key))) continue;
    browser_->move(by);
    follows_chosen_ = true;
  }
  if (!browser_->problem().empty()) {
    ImGui::TextColored(theme::kBad, "%s", browser_->problem().c_str());
  } else if (browser_->replaces()) {
    ImGui::TextColored(theme::kBusy, "The file is there already.");
  } else {
    std::string formats;
    for (const std::string& extension : browser_->question().extensions)
      formats += extension + "  ";
    faint_text("%s", formats.c_str());
  }
  const char* const verb = browser_->replaces() ? "Replace" : saves ? "Save" : "Open";
  is_done |= ImGui::Button(verb, {em(8), 0});
  ImGui::SameLine();
  is_unwanted_ = ImGui::Button("Cancel", {em(8), 0});
  if (is_done) answer_ = browser_->enter();
  wants_keyboard_ |= is_done && !answer_;
}

}  // namespace burnish
