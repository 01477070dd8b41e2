#pragma once

#include <optional>

#include <CLI/CLI.hpp>

#include "common/edit/controls.h"

namespace burnish {

/// Bounds on what edits do, as options of a command. An option that is not given changes nothing.
struct ControlsOptions {
  std::optional<bool> pin_rims;
  std::optional<double> cap;
  std::optional<bool> keep_volume;

  bool is_given() const { return pin_rims || cap || keep_volume; }
  /// Returns `now` with what is given.
  Controls over(Controls now) const;
};

/// Adds --pin-rims, --cap and --keep-volume to a command or a group of its options.
void add_controls_options(CLI::App& command, ControlsOptions& options);

}  // namespace burnish
