// Edits as lines of a script.

#include "common/edit/edit_lines.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <sstream>
#include <utility>

#include "common/base/line_text.h"
#include "common/base/text_lines.h"
#include "common/edit/protect_words.h"

namespace burnish {

Result<Brush> parse_brush(const std::vector<std::string>& words) {
  Brush brush;
  ASSIGN_OR_RETURN(brush.radius, parse_real(words[0]));
  ASSIGN_OR_RETURN(brush.strength, parse_real(words[1]));
  ASSIGN_OR_RETURN(brush.beta, parse_real(words[2]));
  if (words.size() > 3) {
    ASSIGN_OR_RETURN(brush.fall_off, parse_fall_off(words[3]));
  }
  const auto behind = words.begin() + std::min(words.size(), size_t{4});
  RETURN_IF_ERROR(parse_brush_words(std::vector<std::string_view>(behind, words.end()), brush));
  RETURN_IF_ERROR(validate(Stroke{brush, {Vec3d::Zero()}}));
  return brush;
}

namespace {

using Words = std::vector<std::string>;

Result<Stroke> parse_stroke(const Words& words) {
  Stroke stroke;
  size_t first = 4;  // words before the points: WHAT, through
  while (first < words.size() && !parse_real(words[first]).is_ok()) ++first;
  ASSIGN_OR_RETURN(stroke.brush, parse_brush({words.begin(), words.begin() + first}));
  ASSIGN_OR_RETURN(const std::vector<double> numbers, parse_numbers(words, first));
  if (numbers.size() % 3 != 0) return invalid_argument("a point must be three numbers");
  for (size_t i = 0; i < numbers.size(); i += 3)
    stroke.path.emplace_back(numbers[i], numbers[i + 1], numbers[i + 2]);
  return stroke;
}

void write(const Stroke& stroke, LineText& line) {
  const Brush& brush = stroke.brush;
  line << ' ' << brush.radius << ' ' << brush.strength << ' ' << brush.beta << ' '
       << name_of(brush.fall_off) << brush_words(brush);
  for (const Vec3d& point : stroke.path)
    line << ' ' << point.x() << ' ' << point.y() << ' ' << point.z();
}

Result<SetControls> parse_controls(const Words& words) {
  Controls controls;
  ASSIGN_OR_RETURN(controls.pin_rims, parse_switch(words[0]));
  ASSIGN_OR_RETURN(controls.cap, parse_real(words[1]));
  ASSIGN_OR_RETURN(controls.keep_volume, parse_switch(words[2]));
  return SetControls{controls};
}

void write(const Controls& controls, LineText& line) {
  line << (controls.pin_rims ? " on " : " off ") << controls.cap
       << (controls.keep_volume ? " on" : " off");
}

Result<SetEqualiser> parse_bands(const Words& words) {
  Equaliser equaliser;
  for (const std::string& word : words) {
    ASSIGN_OR_RETURN(const Band band, parse_band(word));
    equaliser.bands.push_back(band);
  }
  return SetEqualiser{std::move(equaliser)};
}

void write(const Equaliser& equaliser, LineText& line) {
  for (const Band& band : equaliser.bands) line << ' ' << band.size << ':' << band.gain;
}

Result<SetColour> parse_colours(const Words& words, ColourFilter filter) {
  ASSIGN_OR_RETURN(filter.beta, parse_real(words[0]));
  if (words.size() > 1) {
    ASSIGN_OR_RETURN(filter.alpha, parse_real(words[1]));
  }
  return SetColour{filter};
}

Result<SetTexture> parse_texture(const Words& words, TextureFilter filter) {
  ASSIGN_OR_RETURN(filter.gain, parse_real(words[0]));
  if (words.size() > 1) {
    ASSIGN_OR_RETURN(filter.remove_light, parse_real(words[1]));
  }
  if (words.size() > 2) {
    ASSIGN_OR_RETURN(filter.level_seams, parse_real(words[2]));
  }
  return SetTexture{filter};
}

Result<SetEdges> parse_edges(const Words& words) {
  EdgeFilter edges;
  if (words == Words{"off"}) return SetEdges{edges};
  if (words.size() != 5)
    return invalid_argument("edges are off, or FILTER STRENGTH ANGLE PASSES CRISPNESS");
  ASSIGN_OR_RETURN(edges.kind, parse_normal_filter(words[0]));
  ASSIGN_OR_RETURN(edges.strength, parse_real(words[1]));
  ASSIGN_OR_RETURN(edges.edge_angle, parse_real(words[2]));
  ASSIGN_OR_RETURN(edges.passes, parse_integer(words[3]));
  ASSIGN_OR_RETURN(edges.crispness, parse_real(words[4]));
  return SetEdges{edges};
}

void write(const EdgeFilter& edges, LineText& line) {
  line << ' ' << name_of(edges.kind) << ' ' << edges.strength << ' ' << edges.edge_angle << ' '
       << edges.passes << ' ' << edges.crispness;
}

Result<SwitchEntry> parse_entry(const Words& words) {
  ASSIGN_OR_RETURN(const int number, parse_integer(words[0]));
  ASSIGN_OR_RETURN(const bool on, parse_switch(words[1]));
  return SwitchEntry{static_cast<uint64_t>(std::max(number, 0)), on};
}

/// How a kind of edit is a line. Words are read and written without the command.
struct EditLine {
  EditKind kind;
  CommandForm form;  ///< no name: no script can say this kind
  Result<Change> (*parse)(const Words&, const Settings& now);
  void (*write)(const Change&, LineText&);
};

/// `parse` and `write` are lambdas without captures that give and take the kind's own type.
template <EditKind kKind, typename Parse, typename Write>
constexpr EditLine line(CommandForm form, Parse, Write) {
  constexpr auto kPlace = static_cast<size_t>(kKind);
  return {kKind, form,
          [](const Words& words, const Settings& now) -> Result<Change> {
            ASSIGN_OR_RETURN(auto parsed, Parse{}(words, now));
            return Change(std::in_place_index<kPlace>, std::move(parsed));
          },
          [](const Change& change, LineText& text) { Write{}(std::get<kPlace>(change), text); }};
}

/// A kind that is one word.
template <EditKind kKind, typename Kind>
constexpr EditLine word(std::string_view name, std::string_view help) {
  return line<kKind>(
      {name, 0, 0, help}, [](const Words&, const Settings&) -> Result<Kind> { return Kind{}; },
      [](const Kind&, LineText&) {});
}

template <EditKind kKind>
constexpr EditLine unsaid() {
  return {kKind, {}, nullptr, [](const Change&, LineText&) {}};
}

constexpr std::array<EditLine, std::variant_size_v<Change>> kEditLines = {
    line<EditKind::kGradientScale>(
        {"beta", 1, 1, "beta VALUE: the gradient scale"},
        [](const Words& words, const Settings&) -> Result<SetGradientScale> {
          ASSIGN_OR_RETURN(const double beta, parse_real(words[0]));
          return SetGradientScale{beta};
        },
        [](const SetGradientScale& change, LineText& text) { text << ' ' << change.beta; }),
    line<EditKind::kTransferCurve>(
        {"curve", 1, 1, "curve K:A,K:A,...: the transfer curve"},
        [](const Words& words, const Settings&) -> Result<SetTransferCurve> {
          ASSIGN_OR_RETURN(const TransferCurve curve, TransferCurve::parse(words[0]));
          return SetTransferCurve{curve};
        },
        [](const SetTransferCurve& change, LineText& text) {
          text << ' ' << change.curve.to_string();
        }),
    line<EditKind::kStroke>(
        {"stroke", 7, kAnyWords,
         "stroke RADIUS STRENGTH BETA FALLOFF [WHAT] [through] X Y Z...: paints along points; "
         "through thin walls too"},
        [](const Words& words, const Settings&) { return parse_stroke(words); },
        [](const Stroke& stroke, LineText& text) { write(stroke, text); }),
    unsaid<EditKind::kCellFields>(),
    line<EditKind::kControls>(
        {"controls", 3, 3, "controls PIN CAP KEEP: rims on|off, largest move or 0, volume on|off"},
        [](const Words& words, const Settings&) { return parse_controls(words); },
        [](const SetControls& change, LineText& text) { write(change.controls, text); }),
    line<EditKind::kProtect>(
        {"protect", 1, kAnyWords,
         "protect WORDS: a region in which nothing moves (burnish protect --help)"},
        [](const Words& words, const Settings&) { return parse_protect(words); },
        [](const Protect& change, LineText& text) { text << ' ' << to_words(change); }),
    line<EditKind::kEqualiser>(
        {"bands", 0, 6,
         "bands [SIZE:GAIN]...: gains of details up to these sizes; none removes "
         "them"},
        [](const Words& words, const Settings&) { return parse_bands(words); },
        [](const SetEqualiser& change, LineText& text) { write(change.equaliser, text); }),
    line<EditKind::kPalette>(
        {"palette", 0, kAnyWords,
         "palette [CURVE RRGGBB NAME [; ...]]: the curves that a brush can paint"},
        [](const Words& words, const Settings&) -> Result<SetPalette> {
          ASSIGN_OR_RETURN(Palette palette, parse_palette_line(joined(words)));
          return SetPalette{std::move(palette)};
        },
        [](const SetPalette& change, LineText& text) { text << ' ' << to_line(change.palette); }),
    line<EditKind::kColour>(
        {"colours", 1, 2, "colours BETA [ALPHA]: filters the scan's colours"},
        [](const Words& words, const Settings& now) { return parse_colours(words, now.colour); },
        [](const SetColour& change, LineText& text) {
          text << ' ' << change.filter.beta << ' ' << change.filter.alpha;
        }),
    line<EditKind::kEdges>(
        {"edges", 1, 5, "edges bilateral|edges STRENGTH ANGLE PASSES CRISPNESS, or edges off"},
        [](const Words& words, const Settings&) { return parse_edges(words); },
        [](const SetEdges& change, LineText& text) { write(change.filter, text); }),
    line<EditKind::kTexture>(
        {"texture", 1, 3,
         "texture GAIN [LIGHT [SEAMS]]: details of colours, how much light and seams go"},
        [](const Words& words, const Settings& now) { return parse_texture(words, now.texture); },
        [](const SetTexture& change, LineText& text) {
          text << ' ' << change.filter.gain << ' ' << change.filter.remove_light;
          text << ' ' << change.filter.level_seams;
        }),
    word<EditKind::kUndo, Undo>("undo", "undo: takes back your last edit"),
    word<EditKind::kRedo, Redo>("redo", "redo: brings back what undo took back"),
    line<EditKind::kSwitchEntry>(
        {"switch", 2, 2, "switch NUMBER on|off: switches an entry of the history"},
        [](const Words& words, const Settings&) { return parse_entry(words); },
        [](const SwitchEntry& change, LineText& text) {
          text << ' ' << change.entry << (change.enabled ? " on" : " off");
        }),
    line<EditKind::kSetCheckpoint>(
        {"checkpoint", 1, kAnyWords, "checkpoint NAME"},
        [](const Words& words, const Settings&) -> Result<SetCheckpoint> {
          return SetCheckpoint{joined(words)};
        },
        [](const SetCheckpoint& change, LineText& text) { text << ' ' << change.name; }),
    line<EditKind::kRestoreCheckpoint>(
        {"restore", 1, kAnyWords, "restore NAME: goes back to a checkpoint"},
        [](const Words& words, const Settings&) -> Result<RestoreCheckpoint> {
          return RestoreCheckpoint{joined(words)};
        },
        [](const RestoreCheckpoint& change, LineText& text) { text << ' ' << change.name; }),
    unsaid<EditKind::kDamaged>(),
};

constexpr bool has_a_line_of_each_kind() {
  for (size_t i = 0; i < kEditLines.size(); ++i)
    if (kEditLines[i].kind != static_cast<EditKind>(i) || kEditLines[i].write == nullptr)
      return false;
  return true;
}
static_assert(has_a_line_of_each_kind());

const EditLine* find_line(std::string_view command) {
  for (const EditLine& line : kEditLines)
    if (line.parse && line.form.name == command) return &line;
  return nullptr;
}

std::string names_of_field_edits() {
  std::string names;
  for (const EditLine& line : kEditLines)
    if (line.parse && makes_fields(line.kind))
      names.append(names.empty() ? "" : ", ").append(line.form.name);
  return names;
}

}  // namespace

Status check_words(const CommandForm& form, size_t words) {
  if (words >= form.words_min && words <= form.words_max) return Status::ok();
  return invalid_argument(std::to_string(words) + " words after '" + std::string(form.name) +
                          "'; write " + std::string(form.help));
}

std::vector<CommandForm> edit_commands() {
  std::vector<CommandForm> forms;
  for (const EditLine& line : kEditLines)
    if (line.parse) forms.push_back(line.form);
  return forms;
}

std::optional<EditKind> edit_kind_of(std::string_view command) {
  const EditLine* const line = find_line(command);
  return line ? std::optional(line->kind) : std::nullopt;
}

Result<Change> parse_edit(std::string_view command, const Words& words, const Settings& now) {
  const EditLine* const line = find_line(command);
  if (!line) return invalid_argument("'" + std::string(command) + "' changes no session");
  RETURN_IF_ERROR(check_words(line->form, words.size()));
  ASSIGN_OR_RETURN(Change change, line->parse(words, now));
  RETURN_IF_ERROR(validate(Edit{{}, change}));
  return change;
}

Result<Change> parse_edit_line(std::string_view line, const Settings& now) {
  std::istringstream stream{std::string(line)};
  Words words{std::istream_iterator<std::string>(stream), {}};
  const std::string command = words.empty() ? "" : words.front();
  const auto kind = edit_kind_of(command);
  if (!kind || !makes_fields(*kind))
    return invalid_argument("'" + command + "' is no edit of a scan: it is one of " +
                            names_of_field_edits());
  words.erase(words.begin());
  return parse_edit(command, words, now);
}

std::string line_of(const Change& change) {
  const EditLine& line = kEditLines[change.index()];
  LineText text(LineText::kExact);
  text << line.form.name;
  line.write(change, text);
  return text.text();
}

}  // namespace burnish
