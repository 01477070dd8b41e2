#pragma once

#include "client/app/app.h"

namespace burnish {

/// Runs a script without a window, and draws with LoneRenderer.
/// Fails: as parse_script() and LoneScript::run() do.
Status run_script_file(const std::filesystem::path& script, AppOptions options);

}  // namespace burnish
