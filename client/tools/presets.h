#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "common/edit/equaliser.h"
#include "common/edit/transfer_curve.h"

namespace burnish {

/// A band of the equaliser whose size depends on the scan: it ends at the wavelength of this α, or
/// at waves of so many cells if they are longer. One of both is above 0.
struct PresetBand {
  double alpha = 0;
  double cells = 0;
  double gain = 1;
  bool operator==(const PresetBand&) const = default;
};

/// A named filter at full strength, with a matching brush. It has bands or a β.
struct Preset {
  std::string name;
  std::string description;
  double beta = 1;
  TransferCurve curve{50};
  std::vector<PresetBand> bands = {};
  /// Takes the α of waves of so many cells in place of the curve: for what depends on the scanner.
  std::optional<double> wave_cells = {};
  std::optional<double> brush_beta = {};
};

/// The edits that a preset stands for on one scan.
struct PresetFilter {
  double beta;
  TransferCurve curve;
  Equaliser equaliser;
};

/// The lengths of a scan that presets depend on. Units: of its file.
struct ScanLengths {
  double length_unit = 1;  ///< L
  double cell_size = 1;
  double mean_edge = 0;  ///< 0: unknown; only kept edges depend on it
};

/// Returns the filter of a preset on a scan. The strength runs from 0, which changes nothing, to 1.
PresetFilter filter_of(const Preset& preset, double strength, const ScanLengths& scan);

/// Returns how much of a preset these values are: above 0 to 1, or nothing if they are not of it.
std::optional<double> strength_of(const Preset& preset, const PresetFilter& values,
                                  const ScanLengths& scan);

/// Returns a strength in words: "a little", "half", "most", "all".
std::string_view strength_word(double strength);

/// Says what a preset will do to waves on this scan: "Waves under 8.4 go, those from 8.4 to 37 grow
/// 3 times".
std::string effect_of(const Preset& preset, const ScanLengths& scan);

/// Returns the presets by purpose, then the paper's filters of Figures 1, 2, 3 and 5. The paper
/// draws its curves without numbers and has its own unit of fidelity. So the numbers are ours; they
/// keep the paper's ratio of 5 between the two fidelities of Figure 2.
const std::vector<Preset>& presets();

/// Returns the preset of a name, case-sensitive; null if there is none.
const Preset* find_preset(std::string_view name);

/// Returns the preset of the user's own that keeps these values.
Preset own_preset(const std::string& name, const PresetFilter& values, const ScanLengths& scan);

/// Fails: invalid_argument if the strength is outside 0 to 1.
Status check_strength(double strength);

}  // namespace burnish
