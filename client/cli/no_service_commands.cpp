#include "client/cli/commands.h"

namespace burnish {

void add_service_commands(CommandTable&) {}

}  // namespace burnish
