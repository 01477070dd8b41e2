#include "client/panels/panels.h"

#include <utility>

namespace burnish {

void follow(SliderChange change, Change edit, Document& document) {
  if (change == SliderChange::kMoving) document.preview(std::move(edit));
  if (change == SliderChange::kDone) document.commit(std::move(edit));
}

}  // namespace burnish
