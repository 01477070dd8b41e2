#include "client/app/widgets/drawn_panel.h"

#include "client/app/widgets/places.h"
#include "client/app/widgets/theme.h"
#include "client/app/widgets/value_slider.h"
#include "client/tools/colours.h"

namespace burnish {
namespace {

void draw_ball(Lighting& lighting) {
  const float radius = em(2.6f);
  const ImVec2 from = ImGui::GetCursorScreenPos();
  const ImVec2 middle{from.x + radius, from.y + radius};
  ImGui::InvisibleButton("##lamp", {2 * radius, 2 * radius});
  hint("Drag the lamp. In the picture: Ctrl+Shift and a drag with the right button.");
  if (ImGui::IsItemActive()) {
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    lighting =
        with_lamp_at(lighting, {(mouse.x - middle.x) / radius, (middle.y - mouse.y) / radius});
  }
  const Eigen::Vector2f lamp = lamp_on_ball(lighting).cast<float>();
  ImDrawList* const list = ImGui::GetWindowDrawList();
  list->AddCircleFilled(middle, radius, ImGui::GetColorU32(ImGuiCol_FrameBg), 48);
  constexpr int kRings = 14;
  for (int ring = 0; ring < kRings; ++ring) {  // brighter towards the lamp
    const float part = static_cast<float>(ring) / kRings;
    const float away = part * radius;
    list->AddCircleFilled({middle.x + away * lamp.x(), middle.y - away * lamp.y()},
                          radius * (1 - part), IM_COL32(255, 245, 225, 18), 48);
  }
  list->AddCircleFilled({middle.x + radius * lamp.x(), middle.y - radius * lamp.y()}, em(0.35f),
                        ImGui::GetColorU32(theme::kAccent), 16);
}

class DrawnWidgets : public Widgets {
 public:
  explicit DrawnWidgets(MessageLog& log) : log_(log) {}
  ~DrawnWidgets() override { enable(true); }

  void enable(bool on) override {
    if (!is_enabled_) ImGui::EndDisabled();
    if (!on) ImGui::BeginDisabled();
    is_enabled_ = on;
  }

  void text(std::string_view text) override {
    if (!text.empty()) faint_text("%.*s", static_cast<int>(text.size()), text.data());
  }

  SliderChange slider(const Slider& slider, double& value) override {
    const std::string name(slider.name);
    ImGui::TextUnformatted(name.c_str());
    hint(slider.hint);
    const char* const format = slider.has_two_decimals ? "%.2f" : "%.3g";
    const ValueField field{{name, slider.low, slider.high}, format, log_};
    if (slider.scale == SliderScale::kLinear) return linear_slider(field, value);
    if (slider.scale == SliderScale::kLogarithmic) return log_slider(field, value);
    return beta_slider(name, value, to_imgui(blue_to_red(signed_part_of_beta(value))), log_);
  }

  bool button(const Button& button) override {
    const std::string name(button.name);
    const bool is_pressed =
        noted(name, ImGui::Button(name.c_str(), {button.is_wide ? -1.0f : 0.0f, 0}));
    hint(button.hint);
    return is_pressed;
  }

  std::string_view choice(const Choice& choice, std::string_view chosen) override {
    const Option* const shown = find_option(choice, chosen);
    const std::string name(choice.name), title(shown ? shown->label : choice.otherwise);
    ImGui::SetNextItemWidth(-1);
    if (!noted(name, ImGui::BeginCombo(("##" + name).c_str(), title.c_str(),
                                       ImGuiComboFlags_HeightLarge))) {
      if (shown) hint(shown->hint);
      return {};
    }
    std::string_view taken;
    for (const Option& option : choice.options) {
      const std::string label(option.label);
      if (noted(label, ImGui::Selectable(label.c_str(), &option == shown))) taken = option.word;
      hint(option.hint);
    }
    ImGui::EndCombo();
    return taken;
  }

  void lamp(Lighting& lighting) override { draw_ball(lighting); }

 private:
  static void hint(std::string_view text) {
    if (!text.empty()) burnish::hint(std::string(text).c_str());
  }

  MessageLog& log_;
  bool is_enabled_ = true;
};

}  // namespace

void DrawnPanel::draw(Workspace& workspace) {
  DrawnWidgets widgets(workspace.log);
  panel_.show(workspace, widgets);
}

}  // namespace burnish
