// Lines that use a widget of a panel: `panel preview|commit VALUE PANEL/WIDGET`.

#include <algorithm>
#include <cmath>

#include "client/panels/panels.h"
#include "client/web/core/front_commands.h"
#include "common/base/text_lines.h"

namespace burnish {

namespace {

/// Has the user do one thing with one widget.
class UsedWidgets : public Widgets {
 public:
  UsedWidgets(const char* name, const std::string& value, bool is_done)
      : name_(name), value_(value), is_done_(is_done) {}

  /// Fails: not_found without a widget of this name that can be used; invalid_argument.
  const Status& status() const { return status_; }

  void enable(bool on) override { is_enabled_ = on; }
  void begin_row(int) override {}
  void end_row() override {}
  void text(const char*, const char*, bool) override {}

  SliderChange slider(const Slider& slider, double& value) override {
    if (!is_meant(slider.name)) return SliderChange::kStill;
    const auto number = parse_real(value_);
    status_ = number.status();
    if (number.is_ok() && !std::isfinite(*number))
      status_ = invalid_argument("'" + value_ + "' is not a finite number");
    if (!status_.is_ok()) return SliderChange::kStill;
    value = on_slider(slider, *number);
    return is_done_ ? SliderChange::kDone : SliderChange::kMoving;
  }

  bool button(const char* name, const char*, Pressed, const char*) override {
    if (!is_meant(name)) return false;
    status_ = Status::ok();
    return true;
  }

  bool check(const char* name, const char*, bool& on) override {
    if (!is_meant(name)) return false;
    const auto wanted = parse_switch(value_);
    status_ = wanted.status();
    if (wanted.is_ok()) on = *wanted;
    return wanted.is_ok();
  }

  int choice(const Choice& choice, int) override {
    if (!is_meant(choice.name)) return -1;
    const auto taken = std::ranges::find(choice.options, value_, &Option::word);
    if (taken == choice.options.end()) {
      status_ = invalid_argument("'" + value_ + "' cannot be chosen");
      return -1;
    }
    status_ = Status::ok();
    return static_cast<int>(taken - choice.options.begin());
  }

  void lamp(Lighting&) override {}  // it has lines of its own

 private:
  /// The page rounds to six digits, so an end may come back from either side of it.
  static double on_slider(const Slider& slider, double value) {
    constexpr double kRounding = 1e-5;
    for (const double end : {slider.low, slider.high})
      if (std::abs(value - end) <= kRounding * std::abs(end)) return end;
    return std::clamp(value, slider.low, slider.high);
  }

  bool is_meant(std::string_view name) const { return is_enabled_ && name == name_; }

  std::string_view name_;
  const std::string& value_;
  bool is_done_;
  bool is_enabled_ = true;
  Status status_ = not_found("there is no such widget now");
};

}  // namespace

std::optional<Status> do_panel_line(const FrontWords& line, Workspace& workspace) {
  if (line.command != "panel") return std::nullopt;
  if (const Status has_words = need_words(line, 3); !has_words.is_ok()) return has_words;
  const std::string place = joined({line.words.begin() + 2, line.words.end()});
  const size_t slash = place.find('/');
  for (const SharedPanel& panel : kSharedPanels) {
    if (slash == place.npos || place.compare(0, slash, panel.name) != 0) continue;
    UsedWidgets widgets(place.c_str() + slash + 1, line.words[1], line.words[0] == "commit");
    panel.show(workspace, widgets);
    return widgets.status();
  }
  return not_found("there is no panel of '" + place + "'");
}

}  // namespace burnish
