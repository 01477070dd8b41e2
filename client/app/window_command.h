#pragma once

#include "client/cli/command.h"

namespace burnish {

/// Adds `burnish window`, which is also what `burnish` alone does, and `burnish SCAN`.
void add_window_command(CommandTable& table);

}  // namespace burnish
