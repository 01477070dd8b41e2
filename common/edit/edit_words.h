#pragma once

#include <string>

#include "common/edit/edit.h"

namespace burnish {

/// Says what an edit is, for people and their lists. summary() says the same to programs, in one
/// text that stays as it is.
struct EditWords {
  std::string name;     ///< "Smooth stroke", "Gradient scale 0.25"; a checkpoint's name
  std::string details;  ///< "β 0, brush strength 0.5, 12 points"; empty: the name says all
  double radius = 0;    ///< of the brush, file units; 0: there is none
};

EditWords words_of(const Edit& edit);

}  // namespace burnish
