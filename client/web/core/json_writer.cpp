#include "client/web/core/json_writer.h"

#include <cmath>
#include <cstdio>

#include "common/base/text.h"

namespace burnish {

void JsonWriter::separate() {
  if (needs_comma_) written_ += ',';
  needs_comma_ = true;
}

JsonWriter& JsonWriter::begin(char bracket) {
  separate();
  written_ += bracket;
  needs_comma_ = false;
  return *this;
}

JsonWriter& JsonWriter::end(char bracket) {
  written_ += bracket;
  needs_comma_ = true;
  return *this;
}

JsonWriter& JsonWriter::key(const char* name) {
  text(name);
  written_ += ':';
  needs_comma_ = false;
  return *this;
}

JsonWriter& JsonWriter::text(const char* name, const std::string& value) {
  return key(name).text(value);
}

JsonWriter& JsonWriter::text(const char* name, const char* value) {
  return key(name).text(value);
}

JsonWriter& JsonWriter::text(std::string_view value) {
  separate();
  written_ += '"';
  for (const char c : to_valid_utf8(value)) {
    if (c == '"' || c == '\\') {
      written_ += {'\\', c};
    } else if (static_cast<unsigned char>(c) < 0x20) {
      char escaped[8];
      std::snprintf(escaped, sizeof escaped, "\\u%04x", static_cast<unsigned char>(c));
      written_ += escaped;
    } else {
      written_ += c;
    }
  }
  written_ += '"';
  return *this;
}

JsonWriter& JsonWriter::number(double value) {
  separate();
  char digits[32];
  std::snprintf(digits, sizeof digits, "%.9g", std::isfinite(value) ? value : 0.0);
  written_ += digits;
  return *this;
}

JsonWriter& JsonWriter::whole(int64_t value) {
  separate();
  written_ += std::to_string(value);
  return *this;
}

JsonWriter& JsonWriter::flag(bool value) {
  separate();
  written_ += value ? "true" : "false";
  return *this;
}

JsonWriter& JsonWriter::null() {
  separate();
  written_ += "null";
  return *this;
}

}  // namespace burnish
