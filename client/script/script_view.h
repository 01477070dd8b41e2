#pragma once

#include <string>
#include <string_view>

#include "client/model/documents/document.h"
#include "client/model/workspace/workspace.h"
#include "client/scene/lighting.h"
#include "client/script/script.h"

namespace burnish {

/// Returns true for the commands of change_lighting().
bool is_light_command(std::string_view command);

/// Fails: invalid_argument that names the value and its limit; then nothing changes.
Status change_lighting(const ScriptLine& line, Lighting& lighting);

/// Returns true for the commands of change_view().
bool is_view_command(std::string_view command);

/// Does a command that changes how the session is shown: `camera` to `cavity` in script_help(), but
/// `mirror`. Waits for nothing. Needs: a document. Fails: invalid_argument; failed_precondition.
Status change_view(const ScriptLine& line, Workspace& workspace);

/// Does the command `mirror`. Without a place the plane cuts the middle of the scan's box.
/// Fails: invalid_argument.
Status change_mirror(const ScriptLine& line, Document& document);

}  // namespace burnish
