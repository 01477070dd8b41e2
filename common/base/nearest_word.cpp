#include "common/base/nearest_word.h"

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

namespace burnish {
namespace {

// Levenshtein's distance, a row at a time.
size_t distance(std::string_view a, std::string_view b) {
  std::vector<size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), size_t{0});
  for (size_t i = 0; i < a.size(); ++i) {
    size_t diagonal = std::exchange(row[0], i + 1);
    for (size_t j = 0; j < b.size(); ++j) {
      const size_t exchanged = diagonal + (a[i] != b[j]);
      diagonal = row[j + 1];
      row[j + 1] = std::min({exchanged, diagonal + 1, row[j] + 1});
    }
  }
  return row.back();
}

}  // namespace

std::string nearest_word(std::string_view word, std::span<const std::string> words) {
  static constexpr size_t kLettersMax = 64;  // nobody meant to type more
  if (word.size() > kLettersMax) return {};
  // Two letters that are exchanged count twice.
  size_t least = std::min(word.size(), std::max<size_t>(2, word.size() / 3) + 1);
  std::string nearest;
  for (const std::string& one : words) {
    const size_t letters = distance(word, one);
    if (letters >= least) continue;
    least = letters;
    nearest = one;
  }
  return nearest;
}

std::string did_you_mean(std::string_view word, std::span<const std::string> words) {
  const std::string nearest = nearest_word(word, words);
  return nearest.empty() ? nearest : "; did you mean '" + nearest + "'?";
}

}  // namespace burnish
