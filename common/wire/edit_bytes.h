#pragma once

#include <string>
#include <string_view>

#include "common/edit/edit.h"

namespace burnish {

/// An edit as the journal keeps it: the bytes of its burnish.v1.Edit message.
std::string edit_to_bytes(const Edit& edit);

/// Fails: data_loss when the bytes are no edit, invalid_argument when a value is out of range.
Result<Edit> edit_from_bytes(std::string_view bytes);

}  // namespace burnish
