#pragma once

#include <string>
#include <vector>

#include "client/panels/widgets.h"

namespace burnish {

/// A user who looks at a panel, and does at most one thing.
class User : public Widgets {
 public:
  std::string used;  ///< the widget; empty: only looks
  int option = -1;   ///< to choose
  double value = 0;  ///< to set
  std::vector<std::string> seen;

  void enable(bool) override {}
  void begin_row(int) override {}
  void end_row() override {}
  void text(const char* text, const char*, bool) override { seen.emplace_back(text); }
  SliderChange slider(const Slider& slider, double& shown) override {
    if (!uses(slider.name)) return SliderChange::kStill;
    shown = value;
    return SliderChange::kDone;
  }
  bool button(const char* name, const char*, Pressed, const char*) override { return uses(name); }
  bool check(const char* name, const char*, bool& on) override {
    if (!uses(name)) return false;
    on = !on;
    return true;
  }
  int choice(const Choice& choice, int chosen) override {
    seen.emplace_back(choice.options[static_cast<size_t>(chosen)].word);
    return uses(choice.name) ? option : -1;
  }
  void lamp(Lighting&) override { seen.emplace_back("Lamp"); }

 private:
  bool uses(const char* name) {
    seen.emplace_back(name);
    return name == used;
  }
};

}  // namespace burnish
