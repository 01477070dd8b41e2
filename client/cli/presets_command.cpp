#include <iostream>
#include <memory>

#include "client/cli/commands.h"
#include "client/cli/in_range.h"
#include "client/cli/print_json.h"
#include "client/tools/own_presets.h"

namespace burnish {

namespace {

struct PresetsOptions {
  std::string name;
  double strength = 1;
  ScanLengths scan;
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

nlohmann::ordered_json to_json(const PresetFilter& filter) {
  nlohmann::ordered_json curve = nlohmann::ordered_json::array(), bands = curve;
  for (const auto& point : filter.curve.points()) curve.push_back({point.kappa, point.alpha});
  for (const Band& band : filter.equaliser.bands) bands.push_back({band.size, band.gain});
  return {{"beta", filter.beta}, {"curve", curve}, {"bands", bands}};
}

/// Says what a preset is on a scan.
Status print_preset(const PresetsOptions& options) {
  ASSIGN_OR_RETURN(const Preset preset, find_any_preset(options.name));
  if (options.json) {
    print_json(to_json(filter_of(preset, options.strength, options.scan)));
  } else {
    std::cout << preset.description << ". " << effect_of(preset, options.scan) << ".\n";
  }
  return Status::ok();
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
  for (CLI::Option* option : {length, cell}) option->needs(name);
  name->needs(length)->needs(cell);
  command->add_flag("--json", options->json,
                    "Print JSON: curve as [KAPPA, ALPHA], bands as "
                    "[SIZE, GAIN]");
}

}  // namespace burnish
