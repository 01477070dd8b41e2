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
  JsonWriter& key(const char* name);

  JsonWriter& text(std::string_view value);
  /// Writes nine digits. A number that JSON does not have becomes 0.
  JsonWriter& number(double value);
  JsonWriter& whole(int64_t value);
  JsonWriter& flag(bool value);
  JsonWriter& null();

  // Members of an object.
  // Overloads, for each call with a view has its length too: wasm would be larger.
  JsonWriter& text(const char* name, std::string_view value) { return key(name).text(value); }
  JsonWriter& text(const char* name, const std::string& value);
  JsonWriter& text(const char* name, const char* value);
  JsonWriter& number(const char* name, double value) { return key(name).number(value); }
  JsonWriter& whole(const char* name, int64_t value) { return key(name).whole(value); }
  JsonWriter& flag(const char* name, bool value) { return key(name).flag(value); }

  const std::string& written() const { return written_; }

 private:
  JsonWriter& begin(char bracket);
  JsonWriter& end(char bracket);
  void separate();

  std::string written_;
  bool needs_comma_ = false;
};

}  // namespace burnish
