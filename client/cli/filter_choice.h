#pragma once

#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "client/tools/scan_lengths.h"
#include "common/edit/edit.h"
#include "common/edit/proposed_edges.h"

namespace burnish {

/// A filter as a user names it on the command line.
struct FilterChoice {
  std::optional<double> alpha, beta, wavelength;
  std::optional<TransferCurve> curve;
  std::string preset;
  double strength = 1;
  Equaliser equaliser;
  std::string palette_file;
  std::optional<double> colour_beta, colour_alpha, texture_gain, remove_light, level_seams;
  std::string keep_edges;  ///< name of an edge preset, kAutoEdges or kNoEdges; empty: as before
  std::optional<EdgeProposal> noise;         ///< of the scan, if asks_for_noise()
  std::optional<EdgeFilter> proposed_edges;  ///< with kAutoEdges, by the scan
  std::optional<double> edge_strength, edge_angle, crispness;
  std::optional<int> edge_passes;
  std::vector<std::string> lines;  ///< edits as a script writes them

  /// Returns whether the edits depend on the scan.
  bool needs_scan() const { return wavelength || !preset.empty() || names_edges(); }
  /// Returns whether the edits depend on those before them.
  bool needs_settings() const { return !preset.empty() || !lines.empty(); }
  bool asks_for_proposal() const { return keep_edges == kAutoEdges || preset_keeps_edges(); }
  /// Returns whether the edits depend on the scan's noise.
  bool asks_for_noise() const;
  bool names_edges() const { return !keep_edges.empty() && keep_edges != kNoEdges; }
  bool keeps_edges() const {
    return preset_keeps_edges() || (names_edges() && edge_strength.value_or(1) > 0);
  }
  bool preset_keeps_edges() const;
  /// Returns the filter with the values that the user gave.
  EdgeFilter with_own_values(EdgeFilter filter) const;
  /// Takes what was measured. With kAutoEdges keeps edges as the scan asks; without noise to speak
  /// of that changes nothing. Returns what is done, in words.
  std::string take(const EdgeProposal& proposal);
};

/// Adds --alpha, --wavelength, --curve, --beta, --preset, --strength, --band, --palette,
/// --colour-beta, --colour-alpha, --texture-gain, --remove-light, --level-seams and --edit to a
/// command or a group of its options.
void add_filter_options(CLI::App& command, FilterChoice& choice);

/// Adds --keep-edges and what changes its presets.
void add_edge_options(CLI::App& command, FilterChoice& choice);

/// Says what the choice's preset will do: "Soften: Waves under 8.4 go."; empty without a preset.
std::string told_preset(const FilterChoice& choice, const ScanLengths& scan);

/// Returns the edits that the choice stands for: curve, β, palette, equaliser, colours, texture,
/// then its lines; none for what is not given. A preset ends the bands that are in force. Fails:
/// not_found for an unknown preset; as the file of the palette cannot be read.
Result<std::vector<decltype(Edit::change)>> changes_of(const FilterChoice& choice,
                                                       const ScanLengths& scan,
                                                       const Settings& in_force);

}  // namespace burnish
