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

  void text(const char* text, const char* hint, bool is_announced) override {
    if (!*text) return;
    begin("text", text, hint);
    mark("announced", is_announced);
    json_.close();
  }

  SliderChange slider(const Slider& slider, double& value) override {
    static constexpr const char* kScales[] = {"linear", "logarithmic", "beta"};  // as SliderScale
    begin("slider", slider.name, slider.hint);
    json_.number("value", value).number("low", slider.low).number("high", slider.high);
    json_.text("scale", kScales[static_cast<int>(slider.scale)]);
    json_.whole("digits", slider.digits);
    mark("untitled", !slider.has_title);
    say("note", slider.note);
    json_.close();
    return SliderChange::kStill;
  }

  bool button(const char* name, const char* hint, Pressed pressed, const char* label) override {
    begin("button", name, hint);
    say("label", label);
    if (pressed != Pressed::kIsNoSwitch) json_.flag("pressed", pressed == Pressed::kYes);
    json_.close();
    return false;
  }

  bool check(const char* name, const char* hint, bool& on) override {
    begin("check", name, hint);
    json_.flag("on", on).close();
    return false;
  }

  int choice(const Choice& choice, int chosen) override {
    const Option other{"", choice.otherwise};
    const Option& shown = chosen < 0 ? other : choice.options[static_cast<size_t>(chosen)];
    begin("choice", choice.name, *choice.hint ? choice.hint : shown.hint);
    mark("labelled", choice.is_labelled);
    json_.text("value", shown.word).key("choices").open_list();
    for (const Option& option : choice.options) write(option);
    if (chosen < 0) write(other);
    json_.close_list().close();
    return -1;
  }

  void lamp(Lighting& lighting) override {
    const Eigen::Vector2d lamp = lamp_on_ball(lighting);
    begin("lamp", "Lamp", "");
    json_.number("azimuth", lighting.azimuth_degrees);
    json_.number("elevation", lighting.elevation_degrees);
    json_.number("ballX", lamp.x()).number("ballY", lamp.y()).close();
  }

 private:
  void begin(const char* kind, const char* name, const char* hint) {
    json_.open().text("kind", kind).text("name", name);
    say("hint", hint);
    mark("disabled", !is_enabled_);
  }
  void mark(const char* name, bool is) {
    if (is) json_.flag(name, true);
  }
  void say(const char* name, const char* text) {
    if (*text) json_.text(name, text);
  }
  void write(const Option& option) {
    json_.open_list().text(option.word).text(option.label).close_list();
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
