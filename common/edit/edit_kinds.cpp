#include <array>
#include <type_traits>

#include "common/edit/edit.h"

namespace burnish {
namespace {

/// What holds for all edits of a kind.
struct EditKindFacts {
  EditKind kind;
  const char* name;
  bool makes_fields;
};

/// A kind that has another type's place does not compile.
template <EditKind kKind, typename T>
constexpr EditKindFacts facts(const char* name, bool makes_fields) {
  static_assert(std::is_same_v<std::variant_alternative_t<static_cast<size_t>(kKind), Change>, T>);
  return {kKind, name, makes_fields};
}

constexpr std::array<EditKindFacts, std::variant_size_v<Change>> kEditKinds = {
    facts<EditKind::kGradientScale, SetGradientScale>("slider", true),
    facts<EditKind::kTransferCurve, SetTransferCurve>("curve", true),
    facts<EditKind::kStroke, Stroke>("stroke", true),
    facts<EditKind::kCellFields, SetCellFields>("cells", true),
    facts<EditKind::kControls, SetControls>("controls", true),
    facts<EditKind::kProtect, Protect>("protect", true),
    facts<EditKind::kEqualiser, SetEqualiser>("equaliser", true),
    facts<EditKind::kPalette, SetPalette>("palette", true),
    facts<EditKind::kColour, SetColour>("colour", true),
    facts<EditKind::kUndo, Undo>("undo", false),
    facts<EditKind::kRedo, Redo>("redo", false),
    facts<EditKind::kSwitchEntry, SwitchEntry>("switch", false),
    facts<EditKind::kSetCheckpoint, SetCheckpoint>("checkpoint", false),
    facts<EditKind::kRestoreCheckpoint, RestoreCheckpoint>("restore", false),
    facts<EditKind::kDamaged, Damaged>("damaged", false),
};

constexpr bool has_each_kind_in_order() {
  for (size_t i = 0; i < kEditKinds.size(); ++i)
    if (kEditKinds[i].kind != static_cast<EditKind>(i) || kEditKinds[i].name == nullptr)
      return false;
  return true;
}
static_assert(has_each_kind_in_order());

const EditKindFacts& facts_of(EditKind kind) {
  return kEditKinds[static_cast<size_t>(kind)];
}

}  // namespace

bool makes_fields(EditKind kind) {
  return facts_of(kind).makes_fields;
}

const char* edit_kind_name(EditKind kind) {
  return facts_of(kind).name;
}

}  // namespace burnish
