#include "common/wire/sheets_wire.h"

#include "common/base/text.h"
#include "common/wire/pages_wire.h"

namespace burnish {

static v1::SheetNumber to_wire(const SheetNumber& number) {
  v1::SheetNumber message;
  message.set_page(number.page);
  message.set_halving(number.halving);
  return message;
}

static SheetNumber from_wire(const v1::SheetNumber& message) {
  return {message.page(), message.halving()};
}

v1::FetchSheetsRequest to_wire(const SheetsWish& wish) {
  v1::FetchSheetsRequest message;
  write_fields(wish, message);
  for (const SheetNumber& sheet : wish.sheets) *message.add_sheets() = to_wire(sheet);
  return message;
}

Result<SheetsWish> from_wire(const v1::FetchSheetsRequest& message) {
  RETURN_IF_ERROR(check_name("the scan's name or id", message.scan()));
  const size_t parts =
      static_cast<size_t>(message.blocks_size()) + message.charts_size() + message.sheets_size();
  if (parts == 0 || parts > kSheetPartsPerFetchMax)
    return invalid_argument("a request for " + std::to_string(parts) +
                            " blocks, charts and sheets is outside 1.." +
                            std::to_string(kSheetPartsPerFetchMax));
  auto wish = read_record<SheetsWish>(message);
  for (const v1::SheetNumber& sheet : message.sheets()) wish.sheets.push_back(from_wire(sheet));
  return wish;
}

v1::SheetPart to_wire(const SheetPart& part) {
  v1::SheetPart message;
  *message.mutable_number() = to_wire(part.number);
  message.set_data(part.bytes.data(), part.bytes.size());
  return message;
}

SheetPart from_wire(const v1::SheetPart& message) {
  return {from_wire(message.number()), {message.data().begin(), message.data().end()}};
}

v1::SheetsDescription to_wire(const SheetsDescription& description) {
  v1::SheetsDescription message;
  message.set_head(description.head.data(), description.head.size());
  for (const PagePart& block : description.blocks) *message.add_blocks() = to_wire(block);
  message.set_version(description.version);
  return message;
}

SheetsDescription from_wire(const v1::SheetsDescription& message) {
  SheetsDescription description;
  description.head.assign(message.head().begin(), message.head().end());
  for (const v1::PagePart& block : message.blocks()) description.blocks.push_back(from_wire(block));
  description.version = message.version();
  return description;
}

}  // namespace burnish
