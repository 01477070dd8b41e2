// Panels as lists of widgets, which the page draws.

#include "client/panels/panels.h"
#include "client/web/core/snapshot.h"

namespace burnish {

namespace {

class WrittenWidgets : public Widgets {
 public:
  explicit WrittenWidgets(JsonWriter& json) : json_(json) {}

  void enable(bool on) override { is_enabled_ = on; }

  void text(std::string_view text) override {
    if (!text.empty()) json_.open().text("kind", "text").text("name", text).close();
  }

  SliderChange slider(const Slider& slider, double& value) override {
    static constexpr const char* kScales[] = {"linear", "logarithmic", "beta"};  // as SliderScale
    begin("slider", slider.name, slider.hint);
    json_.number("value", value).number("low", slider.low).number("high", slider.high);
    json_.text("scale", kScales[static_cast<int>(slider.scale)]);
    json_.flag("twoDecimals", slider.has_two_decimals).close();
    return SliderChange::kStill;
  }

  bool button(const Button& button) override {
    begin("button", button.name, button.hint);
    json_.flag("wide", button.is_wide).close();
    return false;
  }

  std::string_view choice(const Choice& choice, std::string_view chosen) override {
    const Option* const shown = find_option(choice, chosen);
    begin("choice", choice.name, shown ? std::string_view(shown->hint) : std::string_view());
    json_.text("value", chosen).key("choices").open_list();
    for (const Option& option : choice.options)
      json_.open_list().text(option.word).text(option.label).close_list();
    if (!shown) json_.open_list().text(chosen).text(choice.otherwise).close_list();
    json_.close_list().close();
    return {};
  }

  void lamp(Lighting& lighting) override {
    const Eigen::Vector2d lamp = lamp_on_ball(lighting);
    begin("lamp", "Lamp", {});
    json_.number("azimuth", lighting.azimuth_degrees);
    json_.number("elevation", lighting.elevation_degrees);
    json_.number("ballX", lamp.x()).number("ballY", lamp.y()).close();
  }

 private:
  void begin(std::string_view kind, std::string_view name, std::string_view hint) {
    json_.open().text("kind", kind).text("name", name);
    if (!hint.empty()) json_.text("hint", hint);
    json_.flag("disabled", !is_enabled_);
  }

  JsonWriter& json_;
  bool is_enabled_ = true;
};

}  // namespace

void write_panels(Workspace& workspace, JsonWriter& json) {
  json.key("panels").open();
  for (const SharedPanel& panel : kSharedPanels) {
    json.key(panel.name).open_list();
    WrittenWidgets widgets(json);
    panel.show(workspace, widgets);
    json.close_list();
  }
  json.close();
}

}  // namespace burnish
