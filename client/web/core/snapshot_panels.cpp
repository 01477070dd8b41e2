// Panels as lists of widgets, which the page draws.

#include "client/panels/panels.h"
#include "client/web/core/snapshot.h"

namespace burnish {

namespace {

class WrittenWidgets : public Widgets {
 public:
  explicit WrittenWidgets(JsonWriter& json) : json_(json) {}

  void enable(bool on) override { is_enabled_ = on; }

  void begin_row(int columns) override {
    json_.open().text("kind", "row").whole("columns", columns).key("widgets").open_list();
  }
  void end_row() override { json_.close_list().close(); }

  void text(const Text& text) override {
    if (text.text.empty()) return;
    begin("text", text.text, text.hint);
    mark("announced", text.is_announced);
    json_.close();
  }

  SliderChange slider(const Slider& slider, double& value) override {
    static constexpr const char* kScales[] = {"linear", "logarithmic", "beta"};  // as SliderScale
    begin("slider", slider.name, slider.hint);
    json_.number("value", value).number("low", slider.low).number("high", slider.high);
    json_.text("scale", kScales[static_cast<int>(slider.scale)]);
    mark("twoDecimals", slider.has_two_decimals);
    mark("untitled", !slider.has_title);
    say("note", slider.note);
    json_.close();
    return SliderChange::kStill;
  }

  bool button(const Button& button) override {
    begin("button", button.name, button.hint);
    say("label", button.label);
    if (button.is_pressed) json_.flag("pressed", *button.is_pressed);
    json_.close();
    return false;
  }

  bool check(const Check& check, bool& on) override {
    begin("check", check.name, check.hint);
    json_.flag("on", on).close();
    return false;
  }

  std::string_view choice(const Choice& choice, std::string_view chosen) override {
    const Option* const shown = find_option(choice, chosen);
    begin("choice", choice.name, choice.hint.empty() && shown ? shown->hint : choice.hint);
    mark("labelled", choice.is_labelled);
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
    say("hint", hint);
    mark("disabled", !is_enabled_);
  }
  void mark(std::string_view name, bool is) {
    if (is) json_.flag(name, true);
  }
  void say(std::string_view name, std::string_view text) {
    if (!text.empty()) json_.text(name, text);
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
