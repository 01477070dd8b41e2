#pragma once

#include <cstdlib>
#include <string>

namespace burnish {

/// A whole number that a longer run of a test is asked for with.
inline int number_from_environment(const char* name, int otherwise) {
  const char* text = std::getenv(name);
  return text ? std::stoi(text) : otherwise;
}

}  // namespace burnish
