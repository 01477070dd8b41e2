#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace burnish {

/// Writes JSON text from left to right. Needs: calls that make a whole object, which nothing
/// checks.
class JsonWriter {
 public:
  JsonWriter& open() { return begin('{'); }
  JsonWriter& close() { return end('}'); }
  JsonWriter& open_list() { return begin('['); }
  JsonWriter& close_list() { return end(']'); }
  JsonWriter& key(std::string_view name);

  JsonWriter& text(std::string_view value);
  /// Writes nine digits. A number that JSON does not have becomes 0.
  JsonWriter& number(double value);
  JsonWriter& whole(int64_t value);
  JsonWriter& flag(bool value);
  JsonWriter& null();

  // Members of an object.
  JsonWriter& text(std::string_view name, std::string_view value) { return key(name).text(value); }
  JsonWriter& number(std::string_view name, double value) { return key(name).number(value); }
  JsonWriter& whole(std::string_view name, int64_t value) { return key(name).whole(value); }
  JsonWriter& flag(std::string_view name, bool value) { return key(name).flag(value); }

  const std::string& written() const { return written_; }

 private:
  JsonWriter& begin(char bracket);
  JsonWriter& end(char bracket);
  void separate();

  std::string written_;
  bool needs_comma_ = false;
};

}  // namespace burnish
