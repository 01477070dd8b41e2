#include "client/panels/panels.h"

#include <algorithm>
#include <utility>

namespace burnish {

const Option* find_option(const Choice& choice, std::string_view word) {
  const auto found = std::ranges::find(choice.options, word, &Option::word);
  return found == choice.options.end() ? nullptr : &*found;
}

void follow(SliderChange change, Change edit, Document& document) {
  if (change == SliderChange::kMoving) document.preview(std::move(edit));
  if (change == SliderChange::kDone) document.commit(std::move(edit));
}

}  // namespace burnish
