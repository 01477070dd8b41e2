#include "common/edit/edit.h"

#include <algorithm>
#include <cstdio>

#include "common/base/text.h"

namespace burnish {

static Status validate_change(const SetGradientScale& change) {
  return check_beta(change.beta);
}

static Status validate_change(const SetTransferCurve&) {
  return Status::ok();
}  // by construction

static Status validate_change(const Stroke& stroke) {
  return validate(stroke);
}

static Status validate_change(const SetCellFields& change) {
  for (size_t i = 0; i < change.cells.size(); ++i) {
    const auto& cell = change.cells[i];
    const std::string where = "cell field " + std::to_string(i + 1);
    RETURN_IF_ERROR(check_alpha(cell.alpha1).with_context(where + ": alpha1"));
    RETURN_IF_ERROR(check_alpha(cell.alpha2).with_context(where + ": alpha2"));
    RETURN_IF_ERROR(check_beta(cell.beta).with_context(where));
    const double largest = std::max(cell.alpha1, cell.alpha2);
    if (largest > kCurveContrastMax * std::min(cell.alpha1, cell.alpha2))
      return invalid_argument(where + ": alpha1 and alpha2 differ by more than a factor of 1000");
  }
  return Status::ok();
}

static Status validate_change(const SetControls& change) {
  return check_controls(change.controls);
}

static Status validate_change(const Protect& change) {
  return validate(change);
}

static Status validate_change(const SetEqualiser& change) {
  return check_equaliser(change.equaliser);
}

static Status validate_change(const SetPalette& change) {
  return check_palette(change.palette);
}

static Status validate_change(const SetColour& change) {
  return check_colour_filter(change.filter);
}

static Status validate_change(const Undo&) {
  return Status::ok();
}

static Status validate_change(const Redo&) {
  return Status::ok();
}

static Status validate_change(const SwitchEntry& change) {
  return change.entry > 0 ? Status::ok() : invalid_argument("entries are numbered from 1");
}

static Status validate_change(const SetCheckpoint& change) {
  return check_name("the checkpoint's name", change.name);
}

static Status validate_change(const RestoreCheckpoint& change) {
  return check_name("the checkpoint's name", change.name);
}

static Status validate_change(const Damaged& change) {
  return data_loss(change.reason);
}

Status validate(const Edit& edit) {
  return std::visit([](const auto& change) { return validate_change(change); }, edit.change);
}

namespace {

std::string number(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%g", x);
  return text;
}

std::string count(size_t n, const char* what) {
  return std::to_string(n) + " " + what + (n == 1 ? "" : "s");
}

std::string painted_text(const Brush& brush) {
  if (brush.band > 0)
    return "band " + std::to_string(brush.band) + " at gain " + number(brush.beta);
  if (brush.curve > 0) return "curve " + std::to_string(brush.curve);
  return (brush.colour ? "colours at beta " : "beta ") + number(brush.beta);
}

struct Summary {
  std::string operator()(const SetGradientScale& change) const {
    return "beta " + number(change.beta);
  }
  std::string operator()(const SetTransferCurve& change) const {
    const auto& points = change.curve.points();
    if (change.curve.is_constant()) return "alpha " + number(points.front().alpha);
    return "curve of " + count(points.size(), "point") + ", contrast " +
           number(change.curve.contrast());
  }
  std::string operator()(const Stroke& stroke) const {
    return "stroke of " + count(stroke.path.size(), "point") + ", radius " +
           number(stroke.brush.radius) + ", " + painted_text(stroke.brush);
  }
  std::string operator()(const SetCellFields& change) const {
    return "fields of " + count(change.cells.size(), "cell");
  }
  std::string operator()(const SetControls& change) const { return text_of(change.controls); }
  std::string operator()(const Protect& change) const { return burnish::summary(change); }
  std::string operator()(const SetEqualiser& change) const { return text_of(change.equaliser); }
  std::string operator()(const SetPalette& change) const { return text_of(change.palette); }
  std::string operator()(const SetColour& change) const { return text_of(change.filter); }
  std::string operator()(const Undo&) const { return "undo"; }
  std::string operator()(const Redo&) const { return "redo"; }
  std::string operator()(const SwitchEntry& change) const {
    return std::string("switch ") + (change.enabled ? "on " : "off ") +
           std::to_string(change.entry);
  }
  std::string operator()(const SetCheckpoint& change) const { return change.name; }
  std::string operator()(const RestoreCheckpoint& change) const { return "restore " + change.name; }
  std::string operator()(const Damaged& change) const { return "skipped: " + change.reason; }
};

}  // namespace

std::string summary(const Edit& edit) {
  return std::visit(Summary{}, edit.change);
}

}  // namespace burnish
