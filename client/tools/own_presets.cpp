#include "client/tools/own_presets.h"

#include <algorithm>
#include <string_view>

#include "common/base/text.h"
#include "common/base/text_lines.h"

namespace burnish {

static std::string name_of(const TextLine& line, size_t first) {
  std::string name;
  for (size_t i = first; i < line.words.size(); ++i)
    name += (name.empty() ? "" : " ") + std::string(line.words[i]);
  return name;
}

constexpr std::string_view kBands = "bands=";

/// Parses ALPHA:GAIN,ALPHA:GAIN,... from fine to coarse.
static Result<std::vector<PresetBand>> read_bands(std::string_view text) {
  std::vector<PresetBand> bands;
  while (!text.empty()) {
    const size_t end = std::min(text.find(','), text.size());
    ASSIGN_OR_RETURN(const Band band, parse_band(text.substr(0, end)));
    bands.push_back({.alpha = band.size, .gain = band.gain});
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  Equaliser equaliser;  // of a scan whose L is 1
  for (const PresetBand& band : bands) equaliser.bands.push_back({1 / band.alpha, band.gain});
  RETURN_IF_ERROR(check_equaliser(equaliser));
  return bands;
}

static Result<Preset> read_preset(const TextLine& line) {
  const bool has_bands = line.words.size() > 2 && line.words[2].starts_with(kBands);
  const size_t first = has_bands ? 3 : 2;
  if (line.words.size() <= first)
    return invalid_argument("write BETA K:A,K:A,... [bands=A:GAIN,...] NAME");
  Preset preset{.name = name_of(line, first), .description = "Your own"};
  ASSIGN_OR_RETURN(preset.beta, parse_real(line.words[0]));
  RETURN_IF_ERROR(check_beta(preset.beta));
  ASSIGN_OR_RETURN(preset.curve, TransferCurve::parse(std::string(line.words[1])));
  if (has_bands) {
    ASSIGN_OR_RETURN(preset.bands,
                     read_bands(std::string_view(line.words[2]).substr(kBands.size())));
  }
  return preset;
}

static std::string text_of_bands(const Preset& preset) {
  std::string text;
  for (const PresetBand& band : preset.bands)
    text += (text.empty() ? std::string(kBands) : ",") + shortest_text(band.alpha) + ":" +
            shortest_text(band.gain);
  return text.empty() ? text : text + " ";
}

Result<std::vector<Preset>> read_own_presets(const std::filesystem::path& path) {
  std::vector<Preset> presets;
  ASSIGN_OR_RETURN(const std::string text, read_own_presets_text(path));
  for (const TextLine& line : split_lines(text)) {
    auto preset = read_preset(line);
    if (!preset.is_ok()) return preset.status().with_context(place(path.string(), line));
    presets.push_back(std::move(preset).value());
  }
  return presets;
}

static Status write_own_presets(const std::filesystem::path& path,
                                const std::vector<Preset>& presets) {
  std::string text;
  for (const Preset& each : presets)
    text += shortest_text(each.beta) + " " + each.curve.to_string() + " " + text_of_bands(each) +
            each.name + "\n";
  return write_own_presets_text(path, text);
}

/// A script takes a number behind a name for the strength; '#' begins a comment in the file.
static Status check_own_name(const std::string& name) {
  RETURN_IF_ERROR(check_name("the preset's name", name));
  if (find_preset(name)) return invalid_argument("preset '" + name + "' is built in");
  const std::vector<TextLine> lines = split_lines(name);
  if (lines.empty() || name.find('#') != std::string::npos)
    return invalid_argument("the preset's name '" + name + "' is empty or has a #");
  if (lines.front().words.front().starts_with(kBands))
    return invalid_argument("the preset's name '" + name + "' begins with " + std::string(kBands));
  if (parse_real(lines.front().words.back()).is_ok())
    return invalid_argument("the preset's name '" + name + "' ends with a number");
  return Status::ok();
}

Status save_own_preset(const std::filesystem::path& path, const Preset& preset) {
  RETURN_IF_ERROR(check_own_name(preset.name));
  ASSIGN_OR_RETURN(std::vector<Preset> presets, read_own_presets(path));
  std::erase_if(presets, [&](const Preset& other) { return other.name == preset.name; });
  if (presets.size() >= kOwnPresetsMax)
    return resource_exhausted("there are " + std::to_string(presets.size()) +
                              " presets of your own, the limit is " +
                              std::to_string(kOwnPresetsMax));
  presets.push_back(preset);
  return write_own_presets(path, presets);
}

Status delete_own_preset(const std::filesystem::path& path, const std::string& name) {
  ASSIGN_OR_RETURN(std::vector<Preset> presets, read_own_presets(path));
  if (std::erase_if(presets, [&](const Preset& each) { return each.name == name; }) == 0)
    return not_found("there is no preset of your own with the name '" + name + "'");
  return write_own_presets(path, presets);
}

Result<Preset> find_any_preset(const std::string& name) {
  if (const Preset* preset = find_preset(name)) return *preset;
  ASSIGN_OR_RETURN(const std::vector<Preset> own, read_own_presets(own_presets_path()));
  const auto found = std::ranges::find(own, name, &Preset::name);
  if (found != own.end()) return *found;
  return not_found("no preset has the name '" + name + "'");
}

}  // namespace burnish
