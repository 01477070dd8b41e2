#pragma once

#include <random>
#include <string>
#include <vector>

#include "common/edit/edit.h"

namespace burnish {

/// Returns an id that no other edit has.
inline std::string random_id() {
  std::random_device device;
  return std::to_string(device()) + std::to_string(device());
}

/// Returns `count` copies of a change, each with its own id.
template <typename Change>
std::vector<Edit> make_edits_of(size_t count, const Change& change) {
  std::vector<Edit> edits;
  for (size_t i = 0; i < count; ++i) edits.push_back({random_id(), change});
  return edits;
}

}  // namespace burnish
