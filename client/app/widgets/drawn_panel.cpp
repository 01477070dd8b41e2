#include "client/app/widgets/drawn_panel.h"

#include "client/app/widgets/places.h"
#include "client/app/widgets/theme.h"
#include "client/app/widgets/value_slider.h"
#include "client/tools/colours.h"

namespace burnish {
namespace {

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
    const bool is_pressed = noted(name, ImGui::Button(name.c_str(), {-1, 0}));
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
