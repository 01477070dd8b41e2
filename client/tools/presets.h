#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "client/tools/scan_lengths.h"
#include "common/edit/equaliser.h"
#include "common/edit/transfer_curve.h"

namespace burnish {

/// A band of the equaliser whose size depends on the scan. One of `alpha` and `cells` is above 0.
struct PresetBand {
  double alpha = 0;  ///< it ends at this wavelength, or a little above the noise's band
  double cells = 0;  ///< the band of the noise, up to waves of so many cells at the most
  double gain = 1;
  bool operator==(const PresetBand&) const = default;
};

/// The longest waves that a preset works on, so that it neither melts nor swells what is narrow.
/// 0: no limit.
struct WaveLimits {
  double cells = 0;  ///< of the grid
  double radii = 0;  ///< of the radius of what bends most: L over ScanLengths::sharp_bend
  double units = 0;  ///< of L
};

/// A named filter at full strength, with a matching brush. It has bands or a β.
struct Preset {
  std::string name;
  std::string description;
  double beta = 1;
  TransferCurve curve{50};
  std::vector<PresetBand> bands = {};
  WaveLimits limits = {};  ///< of where the curve is lowest
  /// Takes waves of so many cells at the most in place of the curve, and as much of β, as the
  /// scan's noise asks for. 0: the noise does not matter.
  double noise_cells = 0;
  /// Keeps edges as the scan's noise asks, so that β raises the surface without its noise.
  bool keeps_edges = false;
  bool ends_edges = false;  ///< as presets with bands do, which exclude kept edges
  std::optional<double> brush_beta = {};
};

/// The edits that a preset stands for on one scan.
struct PresetFilter {
  double beta;
  TransferCurve curve;
  Equaliser equaliser;
  std::optional<EdgeFilter> edges = {};  ///< how edges are kept from now on; nothing: as before
};

/// Returns whether a preset is another filter on a scan with more noise: it has to be measured.
bool follows_noise(const Preset& preset);

/// Returns whether a preset ends or begins to keep edges where they are kept so. Edges that a user
/// keeps otherwise stay.
bool changes_edges(const PresetFilter& filter, const EdgeFilter& in_force);

/// Returns the filter of a preset on a scan. The strength runs from 0, which changes nothing, to 1.
/// On a scan whose noise was not measured it is the filter for much noise.
PresetFilter filter_of(const Preset& preset, double strength, const ScanLengths& scan);

/// Returns how much of a preset these values are: above 0 to 1, or nothing if they are not of it.
std::optional<double> strength_of(const Preset& preset, const PresetFilter& values,
                                  const ScanLengths& scan);

/// Returns a strength in words: "a little", "half", "most", "all".
std::string_view strength_word(double strength);

/// Says what a preset will do to waves on this scan: "Waves under 8.4 go; those from 8.4 to 37 grow
/// 3 times", "The scan has no noise to speak of: nothing changes".
std::string effect_of(const Preset& preset, const ScanLengths& scan);

/// Returns the presets by purpose, then the paper's filters of Figures 1, 2, 3 and 5. The paper
/// draws its curves without numbers and has its own unit of fidelity. So the numbers are ours.
const std::vector<Preset>& presets();

/// Returns the preset of a name, case-sensitive; null if there is none.
const Preset* find_preset(std::string_view name);

/// Returns the preset of the user's own that keeps these values.
Preset own_preset(const std::string& name, const PresetFilter& values, const ScanLengths& scan);

/// Fails: invalid_argument if the strength is outside 0 to 1.
Status check_strength(double strength);

}  // namespace burnish
