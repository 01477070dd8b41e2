#include <iostream>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "client/cli/commands.h"
#include "client/cli/in_range.h"
#include "client/cli/print_json.h"
#include "client/tools/own_presets.h"
#include "common/base/limits.h"
#include "common/edit/proposed_edges.h"

namespace burnish {

namespace {

struct PresetsOptions {
  std::string name;
  double strength = 1;
  ScanLengths scan;
  std::optional<double> noise;
  std::vector<float> curvature;  // range, then the area of each bin
  bool without_edges = false;
  bool json = false;
};

Result<std::vector<Preset>> all_presets() {
  ASSIGN_OR_RETURN(std::vector<Preset> all, read_own_presets(own_presets_path()));
  all.insert(all.begin(), presets().begin(), presets().end());
  return all;
}

Status list_presets(bool json) {
  ASSIGN_OR_RETURN(const std::vector<Preset> all, all_presets());
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const Preset& preset : all) {
    list.push_back({{"name", preset.name}, {"description", preset.description}});
    if (!json) std::cout << preset.name << ": " << preset.description << "\n";
  }
  if (json) print_json(list);
  return Status::ok();
}

/// Says how edges are kept from now on: as the scan's noise proposes, off, or as before.
nlohmann::ordered_json edges_of(const Preset& preset, const PresetFilter& filter,
                                const PresetsOptions& options) {
  if (filter.edges && !filter.edges->is_on()) return kNoEdges;
  const bool keeps = preset.keeps_edges && options.strength > 0 && !options.without_edges;
  return keeps ? nlohmann::ordered_json(kAutoEdges) : nlohmann::ordered_json();
}

nlohmann::ordered_json to_json(const Preset& preset, const PresetFilter& filter,
                               const PresetsOptions& options) {
  nlohmann::ordered_json curve = nlohmann::ordered_json::array(), bands = curve;
  for (const auto& point : filter.curve.points()) curve.push_back({point.kappa, point.alpha});
  for (const Band& band : filter.equaliser.bands) bands.push_back({band.size, band.gain});
  return {{"beta", filter.beta},
          {"curve", curve},
          {"bands", bands},
          {"edges", edges_of(preset, filter, options)},
          {"follows_noise", follows_noise(preset)}};
}

ScanLengths lengths_of(const PresetsOptions& options) {
  ScanLengths scan = options.scan;
  if (options.noise) scan.noise = EdgeProposal{*options.noise, scan.mean_edge, false, {}};
  if (!options.curvature.empty())
    scan.sharp_bend = sharp_bend_of(options.curvature[0], std::span(options.curvature).subspan(1));
  scan.can_keep_edges = !options.without_edges;
  return scan;
}

/// Says what a preset is on a scan.
Status print_preset(const PresetsOptions& options) {
  ASSIGN_OR_RETURN(const Preset preset, find_any_preset(options.name));
  const ScanLengths scan = lengths_of(options);
  if (options.json) {
    print_json(to_json(preset, filter_of(preset, options.strength, scan), options));
  } else {
    std::cout << preset.description << ". " << effect_of(preset, scan) << ".\n";
  }
  return Status::ok();
}

void add_measures(CLI::App& command, PresetsOptions& options, CLI::Option* name) {
  CLI::Option* edge = command
                          .add_option("--mean-edge", options.scan.mean_edge,
                                      "Of the scan: the one that its noise is told in")
                          ->check(above_zero())
                          ->needs(name);
  command
      .add_option("--noise", options.noise,
                  "Of the scan, its deviation, as --keep-edges auto says it; without it the preset "
                  "is that for much noise")
      ->check(in_range(0.0, kCoordinateMagnitudeMax))
      ->needs(edge);
  command
      .add_option("--curvature", options.curvature,
                  "The scan's histogram of curvature: its range, then the area of each bin")
      ->delimiter(',')
      ->type_name("RANGE,AREA,...")
      ->needs(name);
  command
      .add_flag("--without-edges", options.without_edges,
                "The session cannot keep edges: its volume stays")
      ->needs(name);
}

}  // namespace

void add_presets_command(CommandTable& table) {
  const auto options = std::make_shared<PresetsOptions>();
  CLI::App* command =
      table.add("presets", "List the presets, or say what one of them does to a scan", [options] {
        return options->name.empty() ? list_presets(options->json) : print_preset(*options);
      });
  CLI::Option* name = command->add_option("NAME", options->name, "A preset, also one of your own");
  command->add_option("--strength", options->strength, "How much of it, 0 to 1 (default: all)")
      ->check(in_range(0.0, 1.0))
      ->needs(name);
  CLI::Option* length = command
                            ->add_option("--length-unit", options->scan.length_unit,
                                         "L of the scan, as `burnish describe` says it")
                            ->check(above_zero());
  CLI::Option* cell =
      command->add_option("--cell-size", options->scan.cell_size, "Of its grid, likewise")
          ->check(above_zero());
  add_measures(*command, *options, name);
  for (CLI::Option* option : {length, cell}) option->needs(name);
  name->needs(length)->needs(cell);
  command->add_flag("--json", options->json,
                    "Print JSON: curve as [KAPPA, ALPHA], bands as [SIZE, GAIN], edges as "
                    "--keep-edges has them, or null");
}

}  // namespace burnish
