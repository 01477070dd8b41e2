#include "common/edit/preview_change.h"

#include <type_traits>
#include <utility>

namespace burnish {

std::optional<PreviewChange> preview_of(Change change) {
  const auto shown = [](auto& one) -> std::optional<PreviewChange> {
    if constexpr (std::is_constructible_v<PreviewChange, decltype(one)>)
      return PreviewChange(std::move(one));
    else
      return std::nullopt;
  };
  return std::visit(shown, change);
}

}  // namespace burnish
