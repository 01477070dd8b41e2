#include <algorithm>
#include <array>
#include <cstdio>
#include <type_traits>

#include "common/base/text.h"
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

Status check_cells(const SetCellFields& change) {
  for (size_t i = 0; i < change.cells.size(); ++i) {
    const auto& cell = change.cells[i];
    const std::string where = "cell field " + std::to_string(i + 1);
    RETURN_IF_ERROR(check_alpha(cell.alpha1).with_context(where + ": alpha1"));
    RETURN_IF_ERROR(check_alpha(cell.alpha2).with_context(where + ": alpha2"));
    RETURN_IF_ERROR(check_beta(cell.beta).with_context(where));
    const double largest = std::max(cell.alpha1, cell.alpha2);
    if (largest > kCurveContrastMax * std::min(cell.alpha1, cell.alpha2))
      return invalid_argument(where + ": alpha1 and alpha2 differ by more than a factor of 1000");
  }
  return Status::ok();
}

/// The facts that hold for all edits of a kind.
struct EditKindFacts {
  EditKind kind;
  const char* name;
  bool makes_fields;
  int entry;  ///< see entry_number()
  Status (*check)(const Change&);
  std::string (*summary)(const Change&);
};

/// `check` and `summary` are lambdas without captures that take the kind's own type. A kind that
/// has another type's place does not compile.
template <EditKind kKind, typename Check, typename Summary>
constexpr EditKindFacts facts(const char* name, bool makes_fields, int entry, Check, Summary) {
  constexpr auto kPlace = static_cast<size_t>(kKind);
  return {kKind,
          name,
          makes_fields,
          entry,
          [](const Change& change) { return Check{}(std::get<kPlace>(change)); },
          [](const Change& change) { return Summary{}(std::get<kPlace>(change)); }};
}

template <typename T>
constexpr auto kAnyValue = [](const T&) { return Status::ok(); };

constexpr std::array<EditKindFacts, std::variant_size_v<Change>> kEditKinds = {
    facts<EditKind::kGradientScale>(
        "slider", true, 1, [](const SetGradientScale& change) { return check_beta(change.beta); },
        [](const SetGradientScale& change) { return "beta " + number(change.beta); }),
    facts<EditKind::kTransferCurve>(
        "curve", true, 2, kAnyValue<SetTransferCurve>,  // a curve is checked where it is made
        [](const SetTransferCurve& change) { return text_of(change.curve); }),
    facts<EditKind::kStroke>(
        "stroke", true, 3, [](const Stroke& stroke) { return validate(stroke); },
        [](const Stroke& stroke) { return text_of(stroke); }),
    facts<EditKind::kCellFields>(
        "cells", true, 4, [](const SetCellFields& change) { return check_cells(change); },
        [](const SetCellFields& change) {
          return "fields of " + count(change.cells.size(), "cell");
        }),
    facts<EditKind::kControls>(
        "controls", true, 7,
        [](const SetControls& change) { return check_controls(change.controls); },
        [](const SetControls& change) { return text_of(change.controls); }),
    facts<EditKind::kProtect>(
        "protect", true, 8, [](const Protect& change) { return validate(change); },
        [](const Protect& change) { return summary(change); }),
    facts<EditKind::kEqualiser>(
        "equaliser", true, 9,
        [](const SetEqualiser& change) { return check_equaliser(change.equaliser); },
        [](const SetEqualiser& change) { return text_of(change.equaliser); }),
    facts<EditKind::kPalette>(
        "palette", true, 10, [](const SetPalette& change) { return check_palette(change.palette); },
        [](const SetPalette& change) { return text_of(change.palette); }),
    facts<EditKind::kColour>(
        "colour", true, 11,
        [](const SetColour& change) { return check_colour_filter(change.filter); },
        [](const SetColour& change) { return text_of(change.filter); }),
    facts<EditKind::kEdges>(
        "edges", true, 12, [](const SetEdges& change) { return check_edge_filter(change.filter); },
        [](const SetEdges& change) { return text_of(change.filter); }),
    facts<EditKind::kUndo>("undo", false, 0, kAnyValue<Undo>,
                           [](const Undo&) { return std::string("undo"); }),
    facts<EditKind::kRedo>("redo", false, 0, kAnyValue<Redo>,
                           [](const Redo&) { return std::string("redo"); }),
    facts<EditKind::kSwitchEntry>(
        "switch", false, 0,
        [](const SwitchEntry& change) {
          return change.entry > 0 ? Status::ok() : invalid_argument("entries are numbered from 1");
        },
        [](const SwitchEntry& change) {
          return std::string("switch ") + (change.enabled ? "on " : "off ") +
                 std::to_string(change.entry);
        }),
    facts<EditKind::kSetCheckpoint>(
        "checkpoint", false, 5,
        [](const SetCheckpoint& change) {
          return check_name("the checkpoint's name", change.name);
        },
        [](const SetCheckpoint& change) { return change.name; }),
    facts<EditKind::kRestoreCheckpoint>(
        "restore", false, 0,
        [](const RestoreCheckpoint& change) {
          return check_name("the checkpoint's name", change.name);
        },
        [](const RestoreCheckpoint& change) { return "restore " + change.name; }),
    facts<EditKind::kDamaged>(
        "damaged", false, 6, [](const Damaged& change) { return data_loss(change.reason); },
        [](const Damaged& change) { return "skipped: " + change.reason; }),
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
auto fact_of(EditKind kind) {
  return kColumn<kFact>[static_cast<size_t>(kind)];
}

}  // namespace

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

}  // namespace burnish
