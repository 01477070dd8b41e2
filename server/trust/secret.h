#pragma once

#include <string>
#include <string_view>

namespace burnish {

/// Returns 64 hexadecimal digits that nobody can guess.
std::string make_secret();

/// Compares in the same time for all texts of one length. Returns false for two empty texts.
bool is_same_secret(std::string_view a, std::string_view b);

}  // namespace burnish
