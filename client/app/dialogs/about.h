#pragma once

namespace burnish {

/// A window that says what the program is, and where its documents are.
void draw_about(bool& is_open);

}  // namespace burnish
