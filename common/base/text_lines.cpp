#include "common/base/text_lines.h"

#include "common/base/mapped_file.h"
#include "common/base/parse_number.h"

namespace burnish {

static std::vector<std::string_view> split_words(std::string_view line) {
  static constexpr std::string_view kSpace = " \t\r";
  std::vector<std::string_view> words;
  for (size_t at = line.find_first_not_of(kSpace); at != std::string_view::npos;) {
    const size_t end = std::min(line.find_first_of(kSpace, at), line.size());
    words.push_back(line.substr(at, end - at));
    at = line.find_first_not_of(kSpace, end);
  }
  return words;
}

std::vector<TextLine> split_lines(std::string_view text) {
  std::vector<TextLine> lines;
  for (size_t number = 1, begin = 0; begin < text.size(); ++number) {
    const size_t end = std::min(text.find('\n', begin), text.size());
    const std::string_view line = text.substr(begin, end - begin);
    TextLine split{number, split_words(line.substr(0, line.find('#')))};
    if (!split.words.empty()) lines.push_back(std::move(split));
    begin = end + 1;
  }
  return lines;
}

std::string place(const std::string& name, const TextLine& line) {
  return name + ":" + std::to_string(line.number);
}

template <typename Number>
static Result<Number> parse(std::string_view word, const char* kind) {
  if (const auto value = parse_number<Number>(word)) return *value;
  return invalid_argument("'" + std::string(word) + "' is not " + kind);
}

Result<double> parse_real(std::string_view word) {
  return parse<double>(word, "a number");
}
Result<int> parse_integer(std::string_view word) {
  return parse<int>(word, "an integer");
}

Result<bool> parse_switch(std::string_view word) {
  if (word == "on") return true;
  if (word == "off") return false;
  return invalid_argument("'" + std::string(word) + "' is neither on nor off");
}

Result<std::vector<double>> parse_numbers(const std::vector<std::string>& words, size_t first) {
  std::vector<double> numbers;
  for (size_t i = first; i < words.size(); ++i) {
    ASSIGN_OR_RETURN(const double number, parse_real(words[i]));
    numbers.push_back(number);
  }
  return numbers;
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : " ") + word;
  return text;
}

Result<std::string> read_text_file(const std::filesystem::path& path) {
  ASSIGN_OR_RETURN(const MappedFile file, MappedFile::open(path));
  return std::string(file.bytes().begin(), file.bytes().end());
}

}  // namespace burnish
