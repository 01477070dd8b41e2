#include "common/wire/pages_wire.h"

#include "common/base/text.h"

namespace burnish {

static std::string to_text(const std::vector<uint8_t>& bytes) {
  return {bytes.begin(), bytes.end()};
}

static std::vector<uint8_t> to_bytes(const std::string& text) {
  return {text.begin(), text.end()};
}

v1::FetchPagesRequest to_wire(const PagesWish& wish) {
  v1::FetchPagesRequest message;
  write_fields(wish, message);
  return message;
}

Result<PagesWish> from_wire(const v1::FetchPagesRequest& message) {
  RETURN_IF_ERROR(check_name("the scan's name or id", message.scan()));
  const size_t parts = static_cast<size_t>(message.blocks_size()) + message.pages_size();
  if (parts == 0 || parts > kPagePartsPerFetchMax)
    return invalid_argument("a request for " + std::to_string(parts) +
                            " blocks and pages is outside 1.." +
                            std::to_string(kPagePartsPerFetchMax));
  return read_record<PagesWish>(message);
}

v1::PagePart to_wire(const PagePart& part) {
  v1::PagePart message;
  message.set_number(part.number);
  message.set_data(to_text(part.bytes));
  return message;
}

PagePart from_wire(const v1::PagePart& message) {
  return {message.number(), to_bytes(message.data())};
}

v1::PagesDescription to_wire(const PagesDescription& description) {
  v1::PagesDescription message;
  message.set_head(to_text(description.head));
  for (const PagePart& block : description.blocks) *message.add_blocks() = to_wire(block);
  return message;
}

PagesDescription from_wire(const v1::PagesDescription& message) {
  PagesDescription description;
  description.head = to_bytes(message.head());
  for (const v1::PagePart& block : message.blocks()) description.blocks.push_back(from_wire(block));
  return description;
}

}  // namespace burnish
