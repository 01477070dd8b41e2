#pragma once

#include <string>
#include <vector>

#include "client/panels/widgets.h"

namespace burnish {

/// A user who looks at a panel, and does at most one thing.
class User : public Widgets {
 public:
  std::string used;  ///< the widget; empty: only looks
  std::string word;  ///< to choose
  double value = 0;  ///< to set
  std::vector<std::string> seen;

  void enable(bool) override {}
  void begin_row(int) override {}
  void end_row() override {}
  void text(const Text& text) override { seen.emplace_back(text.text); }
  SliderChange slider(const Slider& slider, double& shown) override {
    if (!uses(slider.name)) return SliderChange::kStill;
    shown = value;
    return SliderChange::kDone;
  }
  bool button(const Button& button) override { return uses(button.name); }
  bool check(const Check& check, bool& on) override {
    if (!uses(check.name)) return false;
    on = !on;
    return true;
  }
  std::string_view choice(const Choice& choice, std::string_view chosen) override {
    seen.emplace_back(chosen);
    return uses(choice.name) ? word : std::string_view();
  }
  void lamp(Lighting&) override { seen.emplace_back("Lamp"); }

 private:
  bool uses(std::string_view name) {
    seen.emplace_back(name);
    return name == used;
  }
};

}  // namespace burnish
