#include "server/journal/journal_ends.h"

#include <cstdio>
#include <fcntl.h>
#include <unistd.h>
#include <xxhash.h>

namespace burnish {

// Each session has a line of text: id, number, hash of both.
static constexpr size_t kSlotBytes = 128;
static constexpr size_t kIdBytesMax = 64;

static uint64_t hash_of(const std::string& id, uint64_t number) {
  return XXH3_64bits_withSeed(id.data(), id.size(), number);
}

static std::string line_of(const std::string& id, uint64_t number) {
  char line[kSlotBytes + 1];
  std::snprintf(line, sizeof line, "%s %llu %016llx", id.c_str(),
                static_cast<unsigned long long>(number),
                static_cast<unsigned long long>(hash_of(id, number)));
  return line;
}

JournalEnds::JournalEnds(const std::filesystem::path& path)
    : file_(::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600)) {}

JournalEnds::~JournalEnds() {
  if (file_ >= 0) ::close(file_);
}

std::map<std::string, uint64_t> JournalEnds::read() const {
  const std::lock_guard lock(mutex_);
  std::map<std::string, uint64_t> ends;
  char line[kSlotBytes + 1] = {};
  for (off_t at = 0; ::pread(file_, line, kSlotBytes, at) == static_cast<ssize_t>(kSlotBytes);
       at += static_cast<off_t>(kSlotBytes)) {
    char id[kIdBytesMax + 1] = {};
    unsigned long long number = 0, hash = 0;
    if (std::sscanf(line, "%64s %llu %llx", id, &number, &hash) == 3 && hash == hash_of(id, number))
      ends[id] = number;
  }
  return ends;
}

void JournalEnds::begin(const std::map<std::string, uint64_t>& ends) {
  {
    const std::lock_guard lock(mutex_);
    slots_.clear();
    slots_used_ = 0;
    if (::ftruncate(file_, 0) != 0) return;
  }
  for (const auto& [id, number] : ends) note(id, number);
}

void JournalEnds::note(const std::string& session_id, uint64_t number) {
  const std::lock_guard lock(mutex_);
  if (session_id.size() > kIdBytesMax) return;
  const auto [slot, is_new] = slots_.try_emplace(session_id, slots_used_);
  if (is_new) ++slots_used_;
  write(slot->second, line_of(session_id, number));
}

void JournalEnds::forget(const std::string& session_id) {
  const std::lock_guard lock(mutex_);
  const auto slot = slots_.find(session_id);
  if (slot == slots_.end()) return;
  write(slot->second, "");
  slots_.erase(slot);
}

void JournalEnds::write(size_t slot, const std::string& line) {
  std::string bytes = line;
  bytes.resize(kSlotBytes, ' ');
  bytes.back() = '\n';
  // A missing hint does no harm.
  [[maybe_unused]] const ssize_t written =
      ::pwrite(file_, bytes.data(), bytes.size(), static_cast<off_t>(slot * kSlotBytes));
}

}  // namespace burnish
