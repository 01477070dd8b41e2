#pragma once

#include "client/cli/command.h"

namespace burnish {

/// Adds `burnish window`. `burnish` alone and `burnish SCAN` do the same.
void add_window_command(CommandTable& table);

}  // namespace burnish
