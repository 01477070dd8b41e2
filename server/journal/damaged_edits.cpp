#include "server/journal/damaged_edits.h"

#include "common/wire/edit_bytes.h"

namespace burnish {

std::string id_of_damaged(uint64_t number) {
  return "damaged " + std::to_string(number);
}

AuthoredEdit missing_edit() {
  return {"", 0, {"", Damaged{"its row is missing from the journal"}}};
}

void read_kept_edit(const std::string& bytes, bool is_checksum_right, Edit& edit) {
  if (!is_checksum_right) {
    edit.change = Damaged{"its row in the journal is damaged"};
    return;
  }
  auto read = edit_from_bytes(bytes);
  if (read.is_ok()) {
    edit = std::move(*read);
  } else {
    edit.change = Damaged{read.status().message()};
  }
}

}  // namespace burnish
