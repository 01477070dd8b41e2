#pragma once

#include <optional>

#include "common/edit/edit.h"

namespace burnish {

/// Returns the change as a gesture shows it; nothing for a kind that no gesture shows.
std::optional<PreviewChange> preview_of(Change change);

}  // namespace burnish
