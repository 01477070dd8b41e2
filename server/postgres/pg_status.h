#pragma once

#include <string>

#include "common/base/status.h"

namespace burnish {

/// Makes a Status of a server's error. `sqlstate`: five characters, Appendix A of PostgreSQL's
/// manual. Failures that another try may cure are `unavailable`.
Status pg_status(const std::string& sqlstate, const std::string& message);

/// Returns whether a COMMIT that failed so has changed nothing for sure.
bool is_sure_refusal(const std::string& sqlstate);

/// Returns the text without its last line break.
std::string trimmed_words(std::string text);

}  // namespace burnish
