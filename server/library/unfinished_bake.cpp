#include "server/library/unfinished_bake.h"

#include "server/memory/library_budget.h"
#include "server/prepare/sheets/unfinished_sheets.h"

namespace burnish {

UnfinishedBake::UnfinishedBake() = default;
UnfinishedBake::~UnfinishedBake() = default;

std::unique_ptr<UnfinishedSheets> UnfinishedBake::take(const Key& key) {
  const std::lock_guard lock(mutex_);
  memory_ = {};
  std::unique_ptr<UnfinishedSheets> made = std::move(made_);
  if (made == nullptr || key_ != key) return std::make_unique<UnfinishedSheets>();
  return made;
}

void UnfinishedBake::keep(const Key& key, std::unique_ptr<UnfinishedSheets> made, Quota& memory,
                          const std::filesystem::path& folder) {
  if (!made->pictures || !check_disk_space(folder, made->scratch_bytes()).is_ok()) return;
  auto share = memory.take(kServer, made->memory_bytes());
  if (!share.is_ok()) return;
  const std::lock_guard lock(mutex_);
  key_ = key;
  made_ = std::move(made);
  memory_ = std::move(*share);
}

void UnfinishedBake::forget(const std::string& scan_id) {
  const std::lock_guard lock(mutex_);
  if (key_.first != scan_id) return;
  made_.reset();
  memory_ = {};
}

void UnfinishedBake::forget_others(const std::string& scan_id) {
  const std::lock_guard lock(mutex_);
  if (key_.first == scan_id) return;
  made_.reset();
  memory_ = {};
}

}  // namespace burnish
