#include "client/cli/commands.h"

namespace burnish {

void add_render_command(CommandTable&) {}  // a build without OpenGL cannot draw

}  // namespace burnish
