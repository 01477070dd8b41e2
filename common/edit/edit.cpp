#include "common/edit/edit.h"

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

Status validate(const Edit& edit) {
  return std::visit([](const auto& change) { return validate_change(change); }, edit.change);
}

}  // namespace burnish
