#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

namespace burnish {

/// Files of fetched pages: of one scan each.
inline constexpr const char* kPagesExtension = ".pages";
inline constexpr const char* kIndexExtension = ".index";

/// The room that the pages of all scans take in a folder. Other processes may use the folder too:
/// what they keep later does not count.
class DiskRoom {
 public:
  /// Looks at the folder. `own` is the scan in use, without an extension: its files never go.
  DiskRoom(const std::filesystem::path& own, uint64_t bytes_max);

  /// Makes room for more bytes of the own scan: removes the files of the scans that were not used
  /// for the longest time. Returns false if there is no room even so.
  bool take(uint64_t bytes);

 private:
  struct Scan {
    std::filesystem::path files;  // without an extension
    std::filesystem::file_time_type used;
    uint64_t bytes = 0;
  };

  void remove_oldest();

  uint64_t bytes_max_;
  uint64_t bytes_ = 0;        // of all
  std::vector<Scan> others_;  // the newest first
};

}  // namespace burnish
