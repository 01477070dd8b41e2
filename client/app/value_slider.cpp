#include "client/app/value_slider.h"

#include <algorithm>
#include <cmath>

#include "client/app/theme.h"
#include "common/base/limits.h"

namespace burnish {
namespace {

constexpr float kFieldEm = 4.2f;

// Draws a slider. `place` runs from 0 to 1; to_value and to_place are inverse to each other.
template <typename ToValue, typename ToPlace>
SliderChange slider(const char* id, double& value, const char* format, const ToValue& to_value,
                    const ToPlace& to_place, double low, double high) {
  ImGui::PushID(id);
  SliderChange change = SliderChange::kStill;
  auto place = static_cast<float>(to_place(value));
  ImGui::SetNextItemWidth(-em(kFieldEm) - ImGui::GetStyle().ItemSpacing.x);
  if (ImGui::SliderFloat("##slider", &place, 0, 1, "", ImGuiSliderFlags_NoInput)) {
    value = to_value(place);
    change = SliderChange::kMoving;
  }
  if (ImGui::IsItemDeactivatedAfterEdit()) change = SliderChange::kDone;
  ImGui::SameLine();
  ImGui::SetNextItemWidth(-1);
  double typed = value;
  ImGui::InputDouble("##value", &typed, 0, 0, format);
  if (ImGui::IsItemDeactivatedAfterEdit() && std::isfinite(typed)) {
    value = std::clamp(typed, low, high);
    change = SliderChange::kDone;
  }
  ImGui::PopID();
  return change;
}

}  // namespace

SliderChange beta_slider(const char* id, double& beta, const ImVec4& colour) {
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
  const SliderChange change = slider(id, beta, "%.3g", to_value, to_place, kBetaMin, kBetaMax);
  ImGui::PopStyleColor(2);
  return change;
}

SliderChange log_slider(const char* id, double& value, double low, double high,
                        const char* format) {
  const auto to_value = [=](double place) { return low * std::pow(high / low, place); };
  const auto to_place = [=](double v) { return std::log(v / low) / std::log(high / low); };
  return slider(id, value, format, to_value, to_place, low, high);
}

SliderChange linear_slider(const char* id, double& value, double low, double high,
                           const char* format) {
  const auto to_value = [=](double place) { return low + (high - low) * place; };
  const auto to_place = [=](double v) { return (v - low) / (high - low); };
  return slider(id, value, format, to_value, to_place, low, high);
}

}  // namespace burnish
