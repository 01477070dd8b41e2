#include "client/app/widgets/value_slider.h"

#include <cmath>
#include <cstdio>
#include <imgui.h>
#include <imgui_stdlib.h>

#include "client/app/widgets/places.h"
#include "client/app/widgets/theme.h"
#include "common/base/fixed_text.h"
#include "common/base/limits.h"

namespace burnish {
namespace {

constexpr float kFieldEm = 4.2f;

/// The field that is being typed into, and its text.
struct Typing {
  ImGuiID field = 0;
  std::string text;
};

std::string number_text(int digits, double value) {
  if (digits > 0) return fixed_text(value, digits);
  char text[32];
  std::snprintf(text, sizeof text, "%.2f", value);
  return text;
}

// Takes the text of a field that the user has left. Returns true if the value is another.
bool take_typed(const ValueField& field, const std::string& text, double& value) {
  const auto typed = read_typed_number(field.limits, text);
  if (!typed.is_ok()) {
    field.log.warning(typed.status().message());
    return false;
  }
  if (!typed->note.empty()) field.log.warning(typed->note);
  return std::exchange(value, typed->value) != typed->value;
}

bool draw_field(const ValueField& field, double& value) {
  static Typing typing;  // a user types into one field at a time
  const ImGuiID id = ImGui::GetID("##value");
  const std::string before = number_text(field.digits, value);
  std::string text = typing.field == id ? typing.text : before;
  ImGui::InputText("##value", &text, ImGuiInputTextFlags_AutoSelectAll);
  note_place(field.limits.name + " as a number");
  if (ImGui::IsItemActive()) typing = {id, text};
  if (!ImGui::IsItemDeactivated()) return false;
  typing = {};
  return text != before && take_typed(field, text, value);
}

// Draws a slider. `place` runs from 0 to 1; to_value and to_place are inverse to each other.
template <typename ToValue, typename ToPlace>
SliderChange slider(const ValueField& field, double& value, const ToValue& to_value,
                    const ToPlace& to_place) {
  ImGui::PushID(field.limits.name.c_str());
  SliderChange change = SliderChange::kStill;
  auto place = static_cast<float>(to_place(value));
  ImGui::SetNextItemWidth(-em(kFieldEm) - ImGui::GetStyle().ItemSpacing.x);
  if (ImGui::SliderFloat("##slider", &place, 0, 1, "", ImGuiSliderFlags_NoInput)) {
    value = to_value(place);
    change = SliderChange::kMoving;
  }
  if (ImGui::IsItemDeactivatedAfterEdit()) change = SliderChange::kDone;
  note_place(field.limits.name);
  ImGui::SameLine();
  ImGui::SetNextItemWidth(-1);
  if (draw_field(field, value)) change = SliderChange::kDone;
  ImGui::PopID();
  return change;
}

}  // namespace

SliderChange beta_slider(const std::string& name, double& beta, const ImVec4& colour,
                         MessageLog& log) {
  ImGui::PushStyleColor(ImGuiCol_SliderGrab, colour);
  ImGui::PushStyleColor(ImGuiCol_SliderGrabActive, colour);
  const auto to_value = [](double place) {
    const double right = 2 * place - 1;
    const double value = right < 0 ? 2 * place : 1 + (kBetaMax - 1) * right * right;
    return std::round(value * 100) / 100;
  };
  const auto to_place = [](double value) {
    if (value <= 1) return 0.5 * value;
    return 0.5 + 0.5 * std::sqrt((value - 1) / (kBetaMax - 1));
  };
  const SliderChange change =
      slider({{name, kBetaMin, kBetaMax}, 3, log}, beta, to_value, to_place);
  ImGui::PopStyleColor(2);
  return change;
}

SliderChange log_slider(const ValueField& field, double& value) {
  const double low = field.limits.low, high = field.limits.high;
  const auto to_value = [=](double place) { return low * std::pow(high / low, place); };
  const auto to_place = [=](double v) { return std::log(v / low) / std::log(high / low); };
  return slider(field, value, to_value, to_place);
}

SliderChange linear_slider(const ValueField& field, double& value) {
  const double low = field.limits.low, high = field.limits.high;
  const auto to_value = [=](double place) { return low + (high - low) * place; };
  const auto to_place = [=](double v) { return (v - low) / (high - low); };
  return slider(field, value, to_value, to_place);
}

}  // namespace burnish
