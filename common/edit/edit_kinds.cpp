#include <algorithm>
#include <array>
#include <cstdio>
#include <type_traits>

#include "common/base/text.h"
#include "common/edit/check_between.h"
#include "common/edit/edit.h"

namespace burnish {
namespace {

std::string number(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%g", x);
  return text;
}

std::string count(size_t n, const char* what) {
  return std::to_string(n) + " " + what + (n == 1 ? "" : "s");
}

std::string painted_text(const Brush& brush) {
  if (brush.band > 0)
    return "band " + std::to_string(brush.band) + " at gain " + number(brush.beta);
  if (brush.curve > 0) return "curve " + std::to_string(brush.curve);
  if (brush.edges) return "edges kept at strength " + number(brush.beta);
  if (brush.texture) return "texture gain " + number(brush.beta);
  return (brush.colour ? "colours at beta " : "beta ") + number(brush.beta);
}

std::string text_of(const Stroke& stroke) {
  return "stroke of " + count(stroke.path.size(), "point") + ", radius " +
         number(stroke.brush.radius) + ", " + painted_text(stroke.brush);
}

std::string text_of(const TransferCurve& curve) {
  const auto& points = curve.points();
  if (curve.is_constant()) return "alpha " + number(points.front().alpha);
  return "curve of " + count(points.size(), "point") + ", contrast " + number(curve.contrast());
}

Status check_fields(const SetCellFields::Cell& cell) {
  RETURN_IF_ERROR(check_alpha(cell.alpha1).with_context("alpha1"));
  RETURN_IF_ERROR(check_alpha(cell.alpha2).with_context("alpha2"));
  RETURN_IF_ERROR(check_beta(cell.beta));
  const double largest = std::max(cell.alpha1, cell.alpha2);
  if (largest > kCurveContrastMax * std::min(cell.alpha1, cell.alpha2))
    return invalid_argument("alpha1 and alpha2 differ by more than a factor of 1000");
  return Status::ok();
}

Status check_cell(const SetCellFields::Cell& cell, CellTarget target) {
  if (target == CellTarget::kFields) return check_fields(cell);
  if (target == CellTarget::kEdges) return check_between("strength", cell.beta, 0, 1);
  if (target == CellTarget::kTexture)
    return check_between("texture gain", cell.beta, 0, kTextureGainMax);
  if (cell.beta == 0 || cell.beta == 1) return Status::ok();
  return invalid_argument("protection " + number(cell.beta) + " is neither 0 nor 1");
}

Status check_cells(const SetCellFields& change) {
  for (size_t i = 0; i < change.cells.size(); ++i)
    RETURN_IF_ERROR(check_cell(change.cells[i], change.target)
                        .with_context("cell field " + std::to_string(i + 1)));
  return Status::ok();
}

const char* name_of(CellTarget target) {
  if (target == CellTarget::kEdges) return "edges kept in ";
  if (target == CellTarget::kTexture) return "texture gain in ";
  return target == CellTarget::kProtection ? "protection of " : "fields of ";
}

std::string setting_text(double beta) {
  return number(beta);
}

std::string setting_text(const TransferCurve& curve) {
  return curve.to_string();
}

template <typename Value>
std::string setting_text(const Value& value) {
  return text_of(value);
}

/// How a kind is one of the settings. Without a key it is none.
struct SettingFacts {
  const char* key = nullptr;    ///< see SettingText
  const char* label = nullptr;  ///< see SettingText
  EditEffects effects;
  void (*take)(Settings&, const Change&) = nullptr;
  bool (*is_same)(const Settings&, const Settings&) = nullptr;
  Change (*change)(const Settings&) = nullptr;
  std::string (*text)(const Settings&) = nullptr;
};

constexpr SettingFacts kNoSetting = {
    .effects = {},
    .take = [](Settings&, const Change&) {},
    .is_same = [](const Settings&, const Settings&) { return true; }};

/// `kMember` of Settings is `kValue` of the kind.
template <typename Kind, auto kMember, auto kValue>
constexpr SettingFacts setting(const char* key, const char* label, EditEffects effects) {
  return {key,
          label,
          effects,
          [](Settings& settings, const Change& change) {
            settings.*kMember = std::get<Kind>(change).*kValue;
          },
          [](const Settings& one, const Settings& other) { return one.*kMember == other.*kMember; },
          [](const Settings& settings) -> Change {
            Kind kind;
            kind.*kValue = settings.*kMember;
            return kind;
          },
          [](const Settings& settings) { return setting_text(settings.*kMember); }};
}

/// The facts that hold for all edits of a kind.
struct EditKindFacts {
  EditKind kind;
  const char* name;
  bool makes_fields;
  int entry;  ///< see entry_number()
  Status (*check)(const Change&);
  std::string (*summary)(const Change&);
  SettingFacts setting;
};

/// `check` and `summary` are lambdas without captures that take the kind's own type. A kind that
/// has another type's place does not compile.
template <EditKind kKind, typename Check, typename Summary>
constexpr EditKindFacts facts(const char* name, bool makes_fields, int entry, Check, Summary,
                              SettingFacts setting) {
  constexpr auto kPlace = static_cast<size_t>(kKind);
  return {kKind,
          name,
          makes_fields,
          entry,
          [](const Change& change) { return Check{}(std::get<kPlace>(change)); },
          [](const Change& change) { return Summary{}(std::get<kPlace>(change)); },
          setting};
}

template <typename T>
constexpr auto kAnyValue = [](const T&) { return Status::ok(); };

constexpr std::array<EditKindFacts, std::variant_size_v<Change>> kEditKinds = {
    facts<EditKind::kGradientScale>(
        "slider", true, 1, [](const SetGradientScale& change) { return check_beta(change.beta); },
        [](const SetGradientScale& change) { return "beta " + number(change.beta); },
        setting<SetGradientScale, &Settings::beta, &SetGradientScale::beta>(
            "gradient_scale", "Gradient scale β", {.beta = true})),
    facts<EditKind::kTransferCurve>(
        "curve", true, 2, kAnyValue<SetTransferCurve>,  // a curve is checked where it is made
        [](const SetTransferCurve& change) { return text_of(change.curve); },
        setting<SetTransferCurve, &Settings::curve, &SetTransferCurve::curve>(
            "transfer_curve", "Transfer curve α(κ)", {.metric = true})),
    facts<EditKind::kStroke>(
        "stroke", true, 3, [](const Stroke& stroke) { return validate(stroke); },
        [](const Stroke& stroke) { return text_of(stroke); }, kNoSetting),
    facts<EditKind::kCellFields>(
        "cells", true, 4, [](const SetCellFields& change) { return check_cells(change); },
        [](const SetCellFields& change) {
          return name_of(change.target) + count(change.cells.size(), "cell");
        },
        kNoSetting),
    facts<EditKind::kControls>(
        "controls", true, 7,
        [](const SetControls& change) { return check_controls(change.controls); },
        [](const SetControls& change) { return text_of(change.controls); },
        setting<SetControls, &Settings::controls, &SetControls::controls>("controls", "Controls",
                                                                          {.shown = true})),
    facts<EditKind::kProtect>(
        "protect", true, 8, [](const Protect& change) { return validate(change); },
        [](const Protect& change) { return summary(change); }, kNoSetting),
    facts<EditKind::kEqualiser>(
        "equaliser", true, 9,
        [](const SetEqualiser& change) { return check_equaliser(change.equaliser); },
        [](const SetEqualiser& change) { return text_of(change.equaliser); },
        setting<SetEqualiser, &Settings::equaliser, &SetEqualiser::equaliser>(
            "equaliser", "Equaliser", {.shown = true})),
    facts<EditKind::kPalette>(
        "palette", true, 10, [](const SetPalette& change) { return check_palette(change.palette); },
        [](const SetPalette& change) { return text_of(change.palette); },
        setting<SetPalette, &Settings::palette, &SetPalette::palette>(
            "palette", "Palette", {.metric = true, .shown = true})),
    facts<EditKind::kColour>(
        "colour", true, 11,
        [](const SetColour& change) { return check_colour_filter(change.filter); },
        [](const SetColour& change) { return text_of(change.filter); },
        setting<SetColour, &Settings::colour, &SetColour::filter>("colours", "Colours",
                                                                  {.shown = true})),
    facts<EditKind::kEdges>(
        "edges", true, 12, [](const SetEdges& change) { return check_edge_filter(change.filter); },
        [](const SetEdges& change) { return text_of(change.filter); },
        setting<SetEdges, &Settings::edges, &SetEdges::filter>("edges", "Kept edges",
                                                               {.beta = true})),
    facts<EditKind::kTexture>(
        "texture", true, 13,
        [](const SetTexture& change) { return check_texture_filter(change.filter); },
        [](const SetTexture& change) { return text_of(change.filter); },
        setting<SetTexture, &Settings::texture, &SetTexture::filter>("texture", "Texture",
                                                                     {.shown = true})),
    facts<EditKind::kUndo>(
        "undo", false, 0, kAnyValue<Undo>, [](const Undo&) { return std::string("undo"); },
        kNoSetting),
    facts<EditKind::kRedo>(
        "redo", false, 0, kAnyValue<Redo>, [](const Redo&) { return std::string("redo"); },
        kNoSetting),
    facts<EditKind::kSwitchEntry>(
        "switch", false, 0,
        [](const SwitchEntry& change) {
          return change.entry > 0 ? Status::ok() : invalid_argument("entries are numbered from 1");
        },
        [](const SwitchEntry& change) {
          return std::string("switch ") + (change.enabled ? "on " : "off ") +
                 std::to_string(change.entry);
        },
        kNoSetting),
    facts<EditKind::kSetCheckpoint>(
        "checkpoint", false, 5,
        [](const SetCheckpoint& change) {
          return check_name("the checkpoint's name", change.name);
        },
        [](const SetCheckpoint& change) { return change.name; }, kNoSetting),
    facts<EditKind::kRestoreCheckpoint>(
        "restore", false, 0,
        [](const RestoreCheckpoint& change) {
          return check_name("the checkpoint's name", change.name);
        },
        [](const RestoreCheckpoint& change) { return "restore " + change.name; }, kNoSetting),
    facts<EditKind::kDamaged>(
        "damaged", false, 6, [](const Damaged& change) { return data_loss(change.reason); },
        [](const Damaged& change) { return "skipped: " + change.reason; }, kNoSetting),
};

constexpr bool has_each_kind_in_order() {
  for (size_t i = 0; i < kEditKinds.size(); ++i)
    if (kEditKinds[i].kind != static_cast<EditKind>(i) || kEditKinds[i].name == nullptr)
      return false;
  return true;
}
static_assert(has_each_kind_in_order());

/// One fact of each kind. A program that asks for one of them alone, as the page's core does, has
/// no other column.
template <auto kFact>
constexpr auto kColumn = [] {
  std::array<std::remove_cvref_t<decltype(kEditKinds[0].*kFact)>, kEditKinds.size()> column{};
  for (size_t i = 0; i < column.size(); ++i) column[i] = kEditKinds[i].*kFact;
  return column;
}();

template <auto kFact>
constexpr auto kSettingColumn = [] {
  std::array<std::remove_cvref_t<decltype(kEditKinds[0].setting.*kFact)>, kEditKinds.size()>
      column{};
  for (size_t i = 0; i < column.size(); ++i) column[i] = kEditKinds[i].setting.*kFact;
  return column;
}();

template <auto kFact>
auto fact_of(EditKind kind) {
  return kColumn<kFact>[static_cast<size_t>(kind)];
}

EditEffects effects_of(const Brush& brush) {
  if (brush.curve > 0) return {.metric = true};
  if (brush.band > 0 || brush.colour || brush.texture) return {.shown = true};
  return {.beta = true};
}

}  // namespace

bool needs_colours(const Change& change) {
  const auto* stroke = std::get_if<Stroke>(&change);
  const auto* cells = std::get_if<SetCellFields>(&change);
  if (cells) return cells->target == CellTarget::kTexture;
  return std::holds_alternative<SetColour>(change) || std::holds_alternative<SetTexture>(change) ||
         (stroke && (stroke->brush.colour || stroke->brush.texture));
}

bool makes_fields(EditKind kind) {
  return fact_of<&EditKindFacts::makes_fields>(kind);
}

int entry_number(EditKind kind) {
  return fact_of<&EditKindFacts::entry>(kind);
}

std::optional<EditKind> kind_of_entry(int number) {
  const auto& numbers = kColumn<&EditKindFacts::entry>;
  const auto found = std::ranges::find(numbers, number);
  if (number <= 0 || found == numbers.end()) return std::nullopt;
  return static_cast<EditKind>(found - numbers.begin());
}

const char* edit_kind_name(EditKind kind) {
  return fact_of<&EditKindFacts::name>(kind);
}

Status validate(const Edit& edit) {
  return fact_of<&EditKindFacts::check>(kind_of(edit))(edit.change);
}

std::string summary(const Edit& edit) {
  return fact_of<&EditKindFacts::summary>(kind_of(edit))(edit.change);
}

void Settings::take(const Change& change) {
  kSettingColumn<&SettingFacts::take>[change.index()](*this, change);
}

void Settings::take(const PreviewChange& change) {
  std::visit([this](const auto& one) { take(Change(one)); }, change);
}

EditEffects effects_of(const PreviewChange& gesture) {
  if (const auto* stroke = std::get_if<Stroke>(&gesture)) return effects_of(stroke->brush);
  return std::visit(
      [](const auto& one) { return kSettingColumn<&SettingFacts::effects>[Change(one).index()]; },
      gesture);
}

EditEffects effects_between(const Settings& before, const Settings& after) {
  EditEffects effects;
  for (size_t kind = 0; kind < kEditKinds.size(); ++kind)
    if (!kSettingColumn<&SettingFacts::is_same>[kind](before, after))
      effects |= kSettingColumn<&SettingFacts::effects>[kind];
  return effects;
}

std::vector<Change> changes_that_make(const Settings& settings) {
  std::vector<Change> changes;
  for (const auto change : kSettingColumn<&SettingFacts::change>)
    if (change) changes.push_back(change(settings));
  return changes;
}

std::vector<SettingText> texts_of(const Settings& settings) {
  std::vector<SettingText> texts;
  for (size_t kind = 0; kind < kEditKinds.size(); ++kind)
    if (kSettingColumn<&SettingFacts::key>[kind])
      texts.push_back({kSettingColumn<&SettingFacts::key>[kind],
                       kSettingColumn<&SettingFacts::label>[kind],
                       kSettingColumn<&SettingFacts::text>[kind](settings)});
  return texts;
}

}  // namespace burnish
