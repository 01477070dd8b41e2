#include "client/cli/filter_choice.h"

#include "client/cli/command.h"
#include "client/cli/in_range.h"
#include "client/tools/own_presets.h"
#include "client/tools/presets.h"
#include "common/base/check.h"
#include "common/base/text_lines.h"
#include "common/edit/edit_lines.h"
#include "common/edit/wavelength.h"

namespace burnish {

static void add_alpha_options(CLI::App& command, FilterChoice& choice) {
  CLI::Option* alpha =
      command.add_option("--alpha", choice.alpha, "Fidelity weight: larger keeps more in place")
          ->check(in_range(kAlphaMin, kAlphaMax));
  CLI::Option* wavelength =
      command
          .add_option("--wavelength", choice.wavelength,
                      "Fidelity as a length in the scan's units: at beta 0 this wave is halved")
          ->check(above_zero())
          ->excludes(alpha);
  command
      .add_option_function<std::string>(
          "--curve",
          [&choice](const std::string& text) { choice.curve = TransferCurve::parse(text).value(); },
          "Transfer curve: alpha by curvature, both times L")
      ->type_name("K:A,K:A,...")
      ->check([](const std::string& text) {
        return usage_message(TransferCurve::parse(text).status());
      })
      ->excludes(alpha)
      ->excludes(wavelength);
}

static void add_layer_options(CLI::App& command, FilterChoice& choice) {
  command
      .add_option_function<std::vector<std::string>>(
          "--band",
          [&choice](const std::vector<std::string>& bands) {
            for (const std::string& band : bands)
              choice.equaliser.bands.push_back(parse_band(band).value());
          },
          "A gain for details up to this size, in the scan's units; up to 6, from fine to coarse")
      ->type_name("SIZE:GAIN")
      ->check([](const std::string& text) { return usage_message(parse_band(text).status()); })
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  command
      .add_option("--palette", choice.palette_file,
                  "File of curves for strokes to paint: 'CURVE RRGGBB NAME' lines")
      ->check(not_empty());
  command
      .add_option("--colour-beta", choice.colour_beta,
                  "Gradient scale of the scan's colours: < 1 smooths, 1 keeps, > 1 sharpens")
      ->check(in_range(kBetaMin, kBetaMax));
  command
      .add_option("--colour-alpha", choice.colour_alpha,
                  "Fidelity weight of the scan's colours (default 50)")
      ->check(in_range(kAlphaMin, kAlphaMax));
}

static void add_texture_options(CLI::App& command, FilterChoice& choice) {
  command
      .add_option("--texture-gain", choice.texture_gain,
                  "Details of the scan's colours, finer than a cell: < 1 fades, 1 keeps")
      ->check(in_range(0.0, kTextureGainMax));
  command
      .add_option("--remove-light", choice.remove_light,
                  "How much of the light in the scan's colours goes, 0 to 1")
      ->check(in_range(0.0, 1.0));
  command
      .add_option("--level-seams", choice.level_seams,
                  "How much of the steps between photos goes, in the pictures of OUT, 0 to 1")
      ->check(in_range(0.0, 1.0));
}

static void add_edit_lines(CLI::App& command, FilterChoice& choice) {
  command
      .add_option("--edit", choice.lines,
                  "Any edit, as a script writes it: 'colours 0.5'; more than one in their order")
      ->type_name("LINE")
      ->check(
          [](const std::string& line) { return usage_message(parse_edit_line(line, {}).status()); })
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

void add_filter_options(CLI::App& command, FilterChoice& choice) {
  add_alpha_options(command, choice);
  add_layer_options(command, choice);
  add_texture_options(command, choice);
  add_edit_lines(command, choice);
  CLI::Option* preset = command
                            .add_option("--preset", choice.preset,
                                        "A preset of the window, by name, also one of your own")
                            ->check(not_empty());
  command.add_option("--beta", choice.beta, "Gradient scale: < 1 smooths, 1 keeps, > 1 sharpens")
      ->check(in_range(kBetaMin, kBetaMax))
      ->excludes(preset);
  command
      .add_option("--strength", choice.strength, "How much of the preset, 0 to 1 (default: all)")
      ->check(in_range(0.0, 1.0))
      ->needs(preset);
  for (const char* name : {"--alpha", "--wavelength", "--curve"})
    preset->excludes(command.get_option(name));
}

void add_edge_options(CLI::App& command, FilterChoice& choice) {
  std::string presets = std::string("\n") + kAutoEdges +
                        ": as the scan's own noise and edges ask\n" + kNoEdges + ": keeps none";
  for (const EdgePreset& preset : edge_presets())
    presets.append("\n").append(preset.name).append(": ").append(preset.scans);
  CLI::Option* keep =
      command
          .add_option("--keep-edges", choice.keep_edges,
                      "Take noise away and keep edges before --beta smooths or sharpens" + presets)
          ->type_name("NAME")
          ->check([](const std::string& name) {
            const Status known = find_edge_preset(name).status();
            if (known.is_ok() || name == kAutoEdges || name == kNoEdges) return std::string();
            return usage_message(known) + ", " + kAutoEdges + ", " + kNoEdges;
          });
  command.add_option("--edge-strength", choice.edge_strength, "How much of it (default 1)")
      ->check(in_range(0.0, 1.0))
      ->needs(keep);
  command.add_option("--edge-angle", choice.edge_angle, "Degrees: sharper bends are edges")
      ->check(in_range(kEdgeAngleMin, kEdgeAngleMax))
      ->needs(keep);
  command.add_option("--edge-passes", choice.edge_passes, "More take away longer noise")
      ->check(in_range(1, kNormalPassesMax))
      ->needs(keep);
  command.add_option("--crispness", choice.crispness, "Low for relief, high for machined parts")
      ->check(in_range(0.0, 1.0))
      ->needs(keep);
}

using Changes = std::vector<decltype(Edit::change)>;

static Status add_layers(const FilterChoice& choice, Changes& changes) {
  if (!choice.palette_file.empty()) {
    ASSIGN_OR_RETURN(const std::string text, read_text_file(choice.palette_file));
    ASSIGN_OR_RETURN(Palette palette, parse_palette(text, choice.palette_file));
    if (palette.curves.empty())
      return invalid_argument(choice.palette_file + " has no curves: a palette has 1 to " +
                              std::to_string(kPaletteCurvesMax) + " lines 'CURVE RRGGBB NAME'");
    changes.emplace_back(SetPalette{std::move(palette)});
  }
  if (!choice.equaliser.bands.empty()) {
    RETURN_IF_ERROR(check_equaliser(choice.equaliser).with_context("--band"));
    changes.emplace_back(SetEqualiser{choice.equaliser});
  }
  if (choice.colour_beta || choice.colour_alpha)
    changes.emplace_back(
        SetColour{{choice.colour_alpha.value_or(kAlphaDefault), choice.colour_beta.value_or(1)}});
  if (choice.texture_gain || choice.remove_light || choice.level_seams)
    changes.emplace_back(
        SetTexture{{choice.texture_gain.value_or(1), choice.remove_light.value_or(0),
                    choice.level_seams.value_or(0)}});
  return Status::ok();
}

EdgeFilter FilterChoice::with_own_values(EdgeFilter filter) const {
  filter.strength = edge_strength.value_or(filter.strength);
  filter.edge_angle = edge_angle.value_or(filter.edge_angle);
  filter.passes = edge_passes.value_or(filter.passes);
  filter.crispness = crispness.value_or(filter.crispness);
  return filter;
}

bool FilterChoice::asks_for_noise() const {
  if (asks_for_proposal()) return true;
  const auto found = find_any_preset(preset);
  return found.is_ok() && follows_noise(*found);
}

// Bands exclude kept edges.
bool FilterChoice::preset_keeps_edges() const {
  const auto found = find_any_preset(preset);
  return found.is_ok() && found->keeps_edges && equaliser.bands.empty();
}

std::string FilterChoice::take(const EdgeProposal& proposal) {
  noise = proposal;
  if (keep_edges != kAutoEdges) return {};
  proposed_edges = proposal.filter;
  if (!proposal.filter.is_on()) keep_edges.clear();
  return text_of(proposal, with_own_values(proposal.filter)) + "\n";
}

std::string told_preset(const FilterChoice& choice, const ScanLengths& scan) {
  const auto preset = find_any_preset(choice.preset);
  if (choice.preset.empty() || !preset.is_ok()) return {};
  const bool is_whole = choice.strength == 1;
  return preset->name + ": " + effect_of(*preset, scan) +
         (is_whole ? ".\n" : ", at full strength.\n");
}

// Without another fidelity waves of some edges are its own.
static Status add_edges(const FilterChoice& choice, const ScanLengths& scan, Changes& changes) {
  if (choice.keep_edges == kNoEdges) {
    if (choice.with_own_values({}) != EdgeFilter{})
      return invalid_argument(
          "--keep-edges off keeps none: leave out --edge-strength, --edge-angle, --edge-passes and "
          "--crispness");
    changes.emplace_back(SetEdges{});
  }
  if (!choice.names_edges()) return Status::ok();
  EdgeFilter filter;
  if (choice.keep_edges == kAutoEdges) {
    BURNISH_CHECK(choice.proposed_edges, "the front has asked the scan");
    filter = *choice.proposed_edges;
  } else {
    ASSIGN_OR_RETURN(const EdgePreset preset, find_edge_preset(choice.keep_edges));
    filter = preset.filter;
  }
  changes.emplace_back(SetEdges{choice.with_own_values(filter)});
  if (choice.preset.empty() && !choice.alpha && !choice.wavelength && !choice.curve) {
    BURNISH_CHECK(scan.mean_edge > 0, "the front knows the scan's edges");
    changes.emplace_back(SetTransferCurve{
        TransferCurve(alpha_of_wavelength(scan.length_unit, kEdgeWaveEdges * scan.mean_edge))});
  }
  return Status::ok();
}

// A line may leave out values that an edit before it has set.
static Status add_lines(const FilterChoice& choice, Settings now, Changes& changes) {
  for (const Change& change : changes) now.take(change);
  for (const std::string& line : choice.lines) {
    auto change = parse_edit_line(line, now);
    if (!change.is_ok()) return change.status().with_context("--edit");
    now.take(*change);
    changes.push_back(std::move(change).value());
  }
  return Status::ok();
}

// Edges end before bands begin and the other way round, for they exclude each other.
static void add_preset(const PresetFilter& filter, const FilterChoice& choice,
                       const Settings& in_force, Changes& changes) {
  const bool turns_edges = changes_edges(filter, in_force.edges);
  if (turns_edges && !filter.edges->is_on()) changes.emplace_back(SetEdges{});
  changes.emplace_back(SetTransferCurve{filter.curve});
  changes.emplace_back(SetGradientScale{filter.beta});
  if (choice.equaliser.bands.empty() && filter.equaliser != in_force.equaliser)
    changes.emplace_back(SetEqualiser{filter.equaliser});
  if (turns_edges && filter.edges->is_on()) changes.emplace_back(SetEdges{*filter.edges});
}

Result<Changes> changes_of(const FilterChoice& choice, const ScanLengths& scan,
                           const Settings& in_force) {
  Changes changes;
  if (!choice.preset.empty()) {
    ASSIGN_OR_RETURN(const Preset preset, find_any_preset(choice.preset));
    add_preset(filter_of(preset, choice.strength, scan), choice, in_force, changes);
  }
  if (choice.alpha) changes.emplace_back(SetTransferCurve{TransferCurve(*choice.alpha)});
  if (choice.wavelength)
    changes.emplace_back(
        SetTransferCurve{TransferCurve(alpha_of_wavelength(scan.length_unit, *choice.wavelength))});
  if (choice.curve) changes.emplace_back(SetTransferCurve{*choice.curve});
  if (choice.beta) changes.emplace_back(SetGradientScale{*choice.beta});
  RETURN_IF_ERROR(add_edges(choice, scan, changes));
  RETURN_IF_ERROR(add_layers(choice, changes));
  RETURN_IF_ERROR(add_lines(choice, in_force, changes));
  return changes;
}

}  // namespace burnish
