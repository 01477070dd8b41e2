#pragma once

#include <string>
#include <vector>

#include "common/edit/protect.h"

namespace burnish {

/// Parses a change of the protected region from words, as the command line and scripts have it:
/// `curvature LEAST MOST`, `piece X Y Z`, `lasso M1 ... M16 X Y X Y ...` or `through` for a lasso
/// that goes through, each after `release` to take cells out; `grow CELLS`, `shrink CELLS`,
/// `invert`, `clear`. Fails: invalid_argument that names the word; as validate().
Result<Protect> parse_protect(const std::vector<std::string>& words);

/// Returns words that parse back to the same change.
std::string to_words(const Protect& change);

}  // namespace burnish
