#pragma once

#include <cstdlib>
#include <string>

namespace burnish {

/// Returns the integer of an environment variable, which asks for a longer run of a test.
inline int number_from_environment(const char* name, int otherwise) {
  const char* text = std::getenv(name);
  return text ? std::stoi(text) : otherwise;
}

}  // namespace burnish
