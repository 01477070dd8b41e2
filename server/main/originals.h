#pragma once

#include <memory>

#include "common/base/status.h"
#include "server/config/config.h"
#include "server/library/original_store.h"

namespace burnish {

/// Opens what `library.shared` names: a folder, or a bucket. Fails: if it cannot be used; the
/// message names the key, its value and what to do.
Result<std::unique_ptr<OriginalStore>> open_originals(const ServerConfig& config);

}  // namespace burnish
