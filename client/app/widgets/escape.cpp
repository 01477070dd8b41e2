#include "client/app/widgets/escape.h"

#include <imgui.h>
#include <imgui_internal.h>

namespace burnish {

static bool closed_a_list = false;  // in this picture, as ImGui's own state

static bool is_escape_pressed() {
  return ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape), false);
}

void close_lists_at_escape() {
  const ImVector<ImGuiPopupData>& open = ImGui::GetCurrentContext()->OpenPopupStack;
  const bool is_list =
      !open.empty() && open.back().Window && !(open.back().Window->Flags & ImGuiWindowFlags_Modal);
  closed_a_list = is_list && is_escape_pressed();
  if (closed_a_list) ImGui::ClosePopupsExceptModals();
}

bool is_escaped() {
  return is_escape_pressed() && !closed_a_list;
}

}  // namespace burnish
