#include "client/app/window_command.h"

namespace burnish {

void add_window_command(CommandTable&) {}

}  // namespace burnish
