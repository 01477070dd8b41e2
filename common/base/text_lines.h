#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "common/base/status.h"

namespace burnish {

/// A line of a small text file with at least one word; '#' begins a comment.
struct TextLine {
  size_t number;  ///< from 1
  std::vector<std::string_view> words;
};

/// Splits `text` into lines of words. The words point into `text`.
std::vector<TextLine> split_lines(std::string_view text);

/// "name:12"
std::string place(const std::string& name, const TextLine& line);

/// Fails: invalid_argument naming the word.
Result<double> parse_real(std::string_view word);
Result<int> parse_integer(std::string_view word);

/// Parses "on" or "off". Fails: invalid_argument naming the word.
Result<bool> parse_switch(std::string_view word);

/// Parses the words from `first` on. Fails: invalid_argument naming the word.
Result<std::vector<double>> parse_numbers(const std::vector<std::string>& words, size_t first);

/// Returns the words with a space between.
std::string joined(const std::vector<std::string>& words);

/// Reads a whole file. Fails: as errno says.
Result<std::string> read_text_file(const std::filesystem::path& path);

}  // namespace burnish
