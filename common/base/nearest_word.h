#pragma once

#include <span>
#include <string>
#include <string_view>

namespace burnish {

/// Returns the word that was probably meant: the nearest by letters added, left out or exchanged,
/// if at most a third of `word` is. Empty if none is near.
std::string nearest_word(std::string_view word, std::span<const std::string> words);

/// Returns "; did you mean 'listen'?", or nothing.
std::string did_you_mean(std::string_view word, std::span<const std::string> words);

}  // namespace burnish
