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

  void begin_row(int columns) override {
    columns_ = columns;
    column_ = 0;
  }
  void end_row() override { begin_row(1); }

  void text(const char* text, const char* hint, bool) override {
    if (!*text) return;
    faint_text("%s", text);
    show_hint(hint);
  }

  SliderChange slider(const Slider& slider, double& value) override {
    if (slider.has_title) draw_title(slider);
    const ValueField field{{slider.name, slider.low, slider.high}, slider.digits, log_};
    if (slider.scale == SliderScale::kLinear) return linear_slider(field, value);
    if (slider.scale == SliderScale::kLogarithmic) return log_slider(field, value);
    return beta_slider(slider.name, value, to_imgui(blue_to_red(signed_part_of_beta(value))), log_);
  }

  bool button(const char* name, const char* hint, Pressed pressed, const char* label) override {
    const float width = take_column();
    const bool is_pressed = pressed == Pressed::kYes;
    if (is_pressed)
      ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(ImGuiCol_HeaderActive));
    const bool is_taken = ImGui::Button(*label ? label : name, {width, 0});
    if (is_pressed) ImGui::PopStyleColor();
    note_place(name);
    show_hint(hint);
    return is_taken;
  }

  bool check(const char* name, const char* hint, bool& on) override {
    take_column();
    const bool is_changed = noted(name, ImGui::Checkbox(name, &on));
    show_hint(hint);
    return is_changed;
  }

  int choice(const Choice& choice, int chosen) override {
    const Option* const shown = chosen < 0 ? nullptr : &choice.options[static_cast<size_t>(chosen)];
    const char* const hint = *choice.hint || !shown ? choice.hint : shown->hint;
    if (choice.is_labelled) draw_label(choice.name, hint);
    ImGui::SetNextItemWidth(-1);
    const std::string id = "##" + std::string(choice.name);
    if (!noted(choice.name, ImGui::BeginCombo(id.c_str(), shown ? shown->label : choice.otherwise,
                                              ImGuiComboFlags_HeightLarge))) {
      show_hint(hint);
      return -1;
    }
    int taken = -1;
    for (const Option& option : choice.options) {
      if (noted(option.label, ImGui::Selectable(option.label, &option == shown)))
        taken = static_cast<int>(&option - choice.options.data());
      show_hint(option.hint);
    }
    ImGui::EndCombo();
    return taken;
  }

  void lamp(Lighting& lighting) override { draw_ball(lighting); }

 private:
  static void show_hint(const char* text) {
    if (*text) hint(text);
  }

  static void draw_title(const Slider& slider) {
    ImGui::TextUnformatted(slider.name);
    show_hint(slider.hint);
    if (!*slider.note) return;
    ImGui::SameLine();
    faint_text("%s", slider.note);
    show_hint(slider.hint);
  }

  static void draw_label(const char* name, const char* hint) {
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(name);
    show_hint(hint);
    ImGui::SameLine(em(6));
  }

  /// Goes to the next column of the row, and returns its width.
  float take_column() {
    const float gap = ImGui::GetStyle().ItemSpacing.x;
    if (column_ == 0) {
      left_ = ImGui::GetCursorPosX();
      width_ = (ImGui::GetContentRegionAvail().x - static_cast<float>(columns_ - 1) * gap) /
               static_cast<float>(columns_);
    } else {
      ImGui::SameLine(left_ + static_cast<float>(column_) * (width_ + gap));
    }
    column_ = (column_ + 1) % columns_;
    return width_;
  }

  MessageLog& log_;
  bool is_enabled_ = true;
  int columns_ = 1, column_ = 0;  // of the row, and the next of them
  float left_ = 0, width_ = 0;    // of the first column
};

}  // namespace

void DrawnPanel::draw(Workspace& workspace) {
  DrawnWidgets widgets(workspace.log);
  panel_.show(workspace, widgets);
}

}  // namespace burnish
