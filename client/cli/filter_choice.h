#pragma once

#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "client/tools/presets.h"
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
  std::optional<double> colour_beta, colour_alpha;
  std::string keep_edges;  ///< name of an edge preset, or kAutoEdges; empty: edges are not kept
  std::optional<EdgeFilter> proposed_edges;  ///< with kAutoEdges, by the scan
  std::optional<double> edge_strength, edge_angle, crispness;
  std::optional<int> edge_passes;

  /// Returns whether the edits depend on the scan.
  bool needs_scan() const { return wavelength || !preset.empty() || !keep_edges.empty(); }
  bool asks_for_proposal() const { return keep_edges == kAutoEdges; }
  /// Keeps edges as the scan asks; without noise to speak of it changes nothing.
  void take(const EdgeProposal& proposal) {
    proposed_edges = proposal.filter;
    if (!proposal.filter.is_on()) keep_edges.clear();
  }
  bool keeps_edges() const { return !keep_edges.empty() && edge_strength.value_or(1) > 0; }
};

/// Adds --alpha, --wavelength, --curve, --beta, --preset, --strength, --band, --palette,
/// --colour-beta and --colour-alpha to a command or a group of its options.
void add_filter_options(CLI::App& command, FilterChoice& choice);

/// Adds --keep-edges and what changes its presets.
void add_edge_options(CLI::App& command, FilterChoice& choice);

/// Returns the edits that the choice stands for: curve, β, palette, equaliser, colours; none for
/// what is not given. A preset ends the bands that are in force. Fails: not_found for an unknown
/// preset; as the file of the palette cannot be read.
Result<std::vector<decltype(Edit::change)>> changes_of(const FilterChoice& choice,
                                                       const ScanLengths& scan,
                                                       const Equaliser& in_force);

}  // namespace burnish
