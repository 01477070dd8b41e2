#include "client/tools/own_presets.h"

#include <algorithm>

#include "common/base/text.h"
#include "common/base/text_lines.h"

namespace burnish {

static std::string name_of(const TextLine& line) {
  std::string name;
  for (size_t i = 2; i < line.words.size(); ++i)
    name += (name.empty() ? "" : " ") + std::string(line.words[i]);
  return name;
}

static Result<Preset> read_preset(const TextLine& line) {
  if (line.words.size() < 3) return invalid_argument("write BETA K:A,K:A,... NAME");
  Preset preset{name_of(line), "Your own", 1, TransferCurve(50), {}, {}};
  ASSIGN_OR_RETURN(preset.beta, parse_real(line.words[0]));
  RETURN_IF_ERROR(check_beta(preset.beta));
  ASSIGN_OR_RETURN(preset.curve, TransferCurve::parse(std::string(line.words[1])));
  return preset;
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
    text += shortest_text(each.beta) + " " + each.curve.to_string() + " " + each.name + "\n";
  return write_own_presets_text(path, text);
}

/// A script takes a number behind a name for the strength; '#' begins a comment in the file.
static Status check_own_name(const std::string& name) {
  RETURN_IF_ERROR(check_name("the preset's name", name));
  if (find_preset(name)) return invalid_argument("preset '" + name + "' is built in");
  const std::vector<TextLine> lines = split_lines(name);
  if (lines.empty() || name.find('#') != std::string::npos)
    return invalid_argument("the preset's name '" + name + "' is empty or has a #");
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
