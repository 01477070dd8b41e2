#include "common/edit/check_between.h"

#include <string>

#include "common/base/text.h"

namespace burnish {

Status check_between(const char* what, double value, double least, double most) {
  if (value >= least && value <= most) return Status::ok();
  return invalid_argument(std::string(what) + " " + shortest_text(value) + " is outside " +
                          shortest_text(least) + ".." + shortest_text(most));
}

}  // namespace burnish
