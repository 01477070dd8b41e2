#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "common/edit/transfer_curve.h"

namespace burnish {

/// A named filter: a gradient scale with a transfer curve, and the brush that goes with it.
struct Preset {
  std::string_view name;
  std::string_view source;  ///< which of the paper's figures shows it
  std::string_view description;
  double beta = 1;
  TransferCurve curve{50};
  std::optional<double> brush_beta;
};

/// The paper's filters of Figures 1, 2, 3 and 5, in that order. The paper draws its curves without
/// numbers and measures fidelity in units of its own: the numbers are ours, with its ratio of five
/// between the two fidelities of Figure 2.
const std::vector<Preset>& presets();

/// By name, case-sensitive; null where there is none.
const Preset* find_preset(std::string_view name);

}  // namespace burnish
