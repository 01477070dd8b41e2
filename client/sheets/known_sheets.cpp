#include "client/sheets/known_sheets.h"

#include <string>

namespace burnish {

Status KnownSheets::add(uint32_t block, std::span<const uint8_t> bytes) {
  if (block >= blocks_.size())
    return data_loss("block " + std::to_string(block) + " of sheets: there are " +
                     std::to_string(blocks_.size()));
  ASSIGN_OR_RETURN(SheetBlock decoded, decode_sheet_block(bytes, head_, pages_, block));
  blocks_[block] = std::make_unique<const SheetBlock>(std::move(decoded));
  return Status::ok();
}

std::optional<SheetFacts> KnownSheets::find(uint32_t block, PageId page) const {
  const SheetBlock* known = blocks_[block].get();
  if (known == nullptr) return std::nullopt;
  const size_t place = page - known->begin;
  return SheetFacts{known->charts[place], known->sheets[place]};
}

}  // namespace burnish
