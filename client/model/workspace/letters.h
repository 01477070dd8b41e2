#pragma once

#include <cstdint>
#include <set>
#include <string_view>

namespace burnish {

class Workspace;

/// The letters of texts that the window shows, as far as its font does not load them anyway: those
/// above U+052F in the first plane of Unicode.
class Letters {
 public:
  static constexpr size_t kLettersMax = 4000;  ///< more are left out

  /// Adds the letters of a text in UTF-8. Bytes that are not UTF-8 are passed over.
  void add(std::string_view text);

  const std::set<char16_t>& all() const { return letters_; }

 private:
  std::set<char16_t> letters_;
};

/// Adds the letters of all names and messages that the window may show now.
void add_letters(const Workspace& workspace, Letters& letters);

}  // namespace burnish
