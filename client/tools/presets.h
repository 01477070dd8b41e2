#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "common/edit/transfer_curve.h"

namespace burnish {

/// A named filter at full strength, with a matching brush.
struct Preset {
  std::string name;
  std::string description;
  double beta = 1;
  TransferCurve curve{50};
  /// Takes the α of waves of so many cells in place of the curve: for what depends on the scanner.
  std::optional<double> wave_cells;
  std::optional<double> brush_beta;
};

/// The edits that a preset stands for on one scan.
struct PresetFilter {
  double beta;
  TransferCurve curve;
};

/// Returns the filter of a preset on a scan of this L and cell size, both in file units. The
/// strength runs from 0, which changes nothing, to 1.
PresetFilter filter_of(const Preset& preset, double strength, double length_unit, double cell_size);

/// Returns the presets by purpose, then the paper's filters of Figures 1, 2, 3 and 5. The paper
/// draws its curves without numbers and has its own unit of fidelity. So the numbers are ours; they
/// keep the paper's ratio of 5 between the two fidelities of Figure 2.
const std::vector<Preset>& presets();

/// Returns the preset of a name, case-sensitive; null if there is none.
const Preset* find_preset(std::string_view name);

/// Fails: invalid_argument if the strength is outside 0 to 1.
Status check_strength(double strength);

}  // namespace burnish
