#pragma once

#include <string>

#include "client/model/documents/document.h"

namespace burnish {

/// Returns what undo would take back: "Smooth stroke", "Gradient scale 0.5 and 2 more edits".
/// Empty: nothing, or the history is not the newest.
std::string undo_name(const Document& document);

/// Say what the buttons do: "Takes back your last edit, not those of others: Smooth stroke."
std::string undo_hint(const Document& document);
std::string redo_hint(const Document& document);

}  // namespace burnish
