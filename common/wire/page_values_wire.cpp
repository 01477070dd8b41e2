#include "common/wire/page_values_wire.h"

#include <cmath>

#include "common/wire/session_wire.h"

namespace burnish {

v1::GetPageValuesRequest to_wire(const PageValuesWish& wish) {
  v1::GetPageValuesRequest message;
  message.set_session(wish.session);
  message.set_value(to_wire(wish.value));
  for (const uint32_t page : wish.pages) message.add_pages(page);
  return message;
}

Result<PageValuesWish> from_wire(const v1::GetPageValuesRequest& message) {
  const auto pages = static_cast<size_t>(message.pages_size());
  if (pages == 0 || pages > kValuedPagesMax)
    return invalid_argument("a request for the values of " + std::to_string(pages) +
                            " pages is outside 1.." + std::to_string(kValuedPagesMax));
  ASSIGN_OR_RETURN(const CellValue value, from_wire(message.value()));
  return PageValuesWish{message.session(), value, {message.pages().begin(), message.pages().end()}};
}

v1::PageValues to_wire(const PageValues& values) {
  v1::PageValues message;
  write_fields(values, message);
  message.set_steps(std::string(values.steps.begin(), values.steps.end()));
  return message;
}

Result<PageValues> from_wire(const v1::PageValues& message) {
  const std::string what = "values of page " + std::to_string(message.page());
  if (!std::isfinite(message.low()) || !std::isfinite(message.high()))
    return data_loss(what + " have a bound that is not finite");
  if (message.steps().size() > kPageVerticesMax)
    return data_loss(what + " are for " + std::to_string(message.steps().size()) +
                     " vertices, the limit is " + std::to_string(kPageVerticesMax));
  auto values = read_record<PageValues>(message);
  values.steps.assign(message.steps().begin(), message.steps().end());
  return values;
}

}  // namespace burnish
