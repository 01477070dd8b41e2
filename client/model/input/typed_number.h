#pragma once

#include <string>

#include "common/base/status.h"

namespace burnish {

/// A value that a user may type.
struct TypedValue {
  std::string name;  ///< for messages
  double low = 0;
  double high = 1;
};

/// A number that was typed, and what the user must know about it.
struct TypedNumber {
  double value = 0;
  std::string note;  ///< names the limit that took its place; empty: the number is as typed
};

/// Reads a number with a decimal point or a decimal comma, and keeps it within the value's limits.
/// Fails: invalid_argument for anything else; the message names value and text.
Result<TypedNumber> read_typed_number(const TypedValue& value, const std::string& text);

}  // namespace burnish
