#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <string>

namespace burnish {

/// The number of each session's last edit, in a file beside the journal. It shows edits that SQLite
/// cuts off the end of a damaged write-ahead log. It is only a hint, written after the commits and
/// never waited for, so it is behind the journal or level with it. Lines that cannot be read or
/// written are left out. Thread-safe.
class JournalEnds {
 public:
  explicit JournalEnds(const std::filesystem::path& path);
  ~JournalEnds();
  JournalEnds(const JournalEnds&) = delete;
  JournalEnds& operator=(const JournalEnds&) = delete;

  /// Returns the last number of each session, by id.
  std::map<std::string, uint64_t> read() const;

  /// Writes these sessions and no others.
  void begin(const std::map<std::string, uint64_t>& ends);

  void note(const std::string& session_id, uint64_t number);
  void forget(const std::string& session_id);

 private:
  void write(size_t slot, const std::string& line);

  mutable std::mutex mutex_;
  int file_;                             // -1 without a file
  std::map<std::string, size_t> slots_;  // by session: its place in the file
  size_t slots_used_ = 0;
};

}  // namespace burnish
