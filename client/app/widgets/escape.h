#pragma once

namespace burnish {

/// Closes the menus and lists that are open, if Escape was pressed. Call it once per picture,
/// before anything is drawn.
void close_lists_at_escape();

/// Returns whether Escape was pressed and closed no list: it is meant for the dialog.
bool is_escaped();

}  // namespace burnish
