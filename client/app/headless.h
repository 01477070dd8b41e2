#pragma once

#include "client/app/app.h"

namespace burnish {

/// Does what a script says without a window, drawing through EGL; where there is no driver, without
/// pictures. Fails: as parse_script() and ScriptRunner::run() do.
Status run_script_file(const std::filesystem::path& script, AppOptions options);

}  // namespace burnish
