#include "client/app/overlay/toasts.h"

#include <ctime>

#include "client/app/widgets/places.h"
#include "client/app/widgets/theme.h"

namespace burnish {

static constexpr std::chrono::seconds kShown{6};
static constexpr std::chrono::seconds kErrorShown{15};
static constexpr size_t kToastsMax = 4;

static ImVec4 colour_of(Severity severity) {
  if (severity == Severity::kError) return theme::kBad;
  return severity == Severity::kWarning ? theme::kBusy : theme::kText;
}

static bool is_new(const Message& message) {
  const auto age = std::chrono::system_clock::now() - message.time;
  return age < (message.severity == Severity::kError ? kErrorShown : kShown);
}

bool Toasts::is_visible(const Workspace& workspace) const {
  if (!workspace.activities().empty()) return true;
  const auto& messages = workspace.log.messages();
  return !messages.empty() && is_new(messages.back());
}

static void draw_activity(Activity& activity) {
  ImGui::PushID(&activity);
  const Activity::State state = activity.state();
  ImGui::TextUnformatted(activity.title().c_str());
  std::string phase = state.phase.empty() ? "…" : state.phase;
  if (state.seconds_left) phase += ", " + time_left_text(*state.seconds_left);
  ImGui::ProgressBar(static_cast<float>(state.fraction), {em(21), 0}, phase.c_str());
  ImGui::SameLine();
  ImGui::BeginDisabled(activity.is_cancelled());
  if (ImGui::Button("Cancel")) activity.cancel();
  hint("Ends this work. Nothing of it is left.");
  ImGui::EndDisabled();
  ImGui::PopID();
}

void Toasts::draw(Workspace& workspace) {
  covered_low = covered_high = {0, 0};
  if (!is_visible(workspace)) return;
  const float margin = em(0.7f);
  ImGui::SetNextWindowPos({lower_left.x + margin, lower_left.y - margin}, 0, {0, 1});
  ImGui::SetNextWindowBgAlpha(kOverlayOpacity);
  ImGui::SetNextWindowSizeConstraints(
      {em(8), 0}, {em(34), lower_left.y - 2 * margin - ImGui::GetFrameHeight()});
  ImGui::Begin("##toasts", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize |
                   ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoSavedSettings);
  const auto& messages = workspace.log.messages();
  for (size_t i = messages.size() - std::min(messages.size(), kToastsMax); i < messages.size();
       ++i) {
    if (!is_new(messages[i])) continue;
    ImGui::PushStyleColor(ImGuiCol_Text, colour_of(messages[i].severity));
    ImGui::PushTextWrapPos(em(31));
    ImGui::TextUnformatted(messages[i].text.c_str());
    ImGui::PopTextWrapPos();
    ImGui::PopStyleColor();
  }
  for (const auto& activity : workspace.activities()) draw_activity(*activity);
  covered_low = ImGui::GetWindowPos();
  covered_high = {covered_low.x + ImGui::GetWindowWidth(),
                  covered_low.y + ImGui::GetWindowHeight()};
  note_window("Toasts");
  ImGui::End();
}

void draw_message_log(const MessageLog& log, bool& is_open) {
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({screen.x / 2, screen.y / 2}, ImGuiCond_Appearing, {0.5f, 0.5f});
  ImGui::SetNextWindowSize({em(44), em(22)}, ImGuiCond_Appearing);
  if (ImGui::Begin("Messages", &is_open, ImGuiWindowFlags_NoCollapse)) {
    for (auto message = log.messages().rbegin(); message != log.messages().rend(); ++message) {
      char text[16];
      const time_t seconds = std::chrono::system_clock::to_time_t(message->time);
      std::tm local{};
      localtime_r(&seconds, &local);
      std::strftime(text, sizeof text, "%T", &local);
      faint_text("%s", text);
      ImGui::SameLine(em(6));
      ImGui::PushStyleColor(ImGuiCol_Text, colour_of(message->severity));
      ImGui::TextWrapped("%s", message->text.c_str());
      ImGui::PopStyleColor();
    }
    if (log.messages().empty()) faint_text("nothing yet");
    note_window("Messages");
  }
  ImGui::End();
}

}  // namespace burnish
