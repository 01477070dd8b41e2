#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "common/edit/transfer_curve.h"

namespace burnish {

/// A named filter: a gradient scale, a transfer curve and a matching brush.
struct Preset {
  std::string_view name;
  std::string_view source;  ///< the paper's figure that shows it
  std::string_view description;
  double beta = 1;
  TransferCurve curve{50};
  std::optional<double> brush_beta;
};

/// Returns the paper's filters of Figures 1, 2, 3 and 5, in that order. The paper draws its curves
/// without numbers and has its own unit of fidelity. So the numbers are ours; they keep the paper's
/// ratio of 5 between the two fidelities of Figure 2.
const std::vector<Preset>& presets();

/// Returns the preset of a name, case-sensitive; null if there is none.
const Preset* find_preset(std::string_view name);

}  // namespace burnish
