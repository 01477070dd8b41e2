#pragma once

#include <string>
#include <utility>

#include "common/base/status.h"

namespace burnish {

/// How a write to the journal ended. There are three ends, because a commit may fail after the data
/// has reached the disk. Nobody knows then whether a later reader finds it.
class WriteOutcome {
 public:
  enum class End { kOnDisk, kRefused, kUnknown };

  /// On disk.
  WriteOutcome() = default;

  static WriteOutcome refused(Status why) { return {End::kRefused, std::move(why)}; }
  static WriteOutcome unknown(Status why) { return {End::kUnknown, std::move(why)}; }

  /// On disk if `status` is ok, else refused.
  static WriteOutcome of(const Status& status) {
    return status.is_ok() ? WriteOutcome() : refused(status);
  }

  End end() const { return end_; }
  bool is_on_disk() const { return end_ == End::kOnDisk; }
  bool is_unknown() const { return end_ == End::kUnknown; }

  /// The failure that the journal met; ok if the write is on disk.
  const Status& why() const { return why_; }

  /// Says why the write is not on disk; ok if it is. An unknown write is `unavailable`: the same
  /// write may come again, and the journal says then whether it knows it.
  Status status() const {
    if (!is_unknown()) return why_;
    return unavailable("the write may or may not be on disk (" + why_.message() + ")");
  }

 private:
  WriteOutcome(End end, Status why) : end_(end), why_(std::move(why)) {}

  End end_ = End::kOnDisk;
  Status why_;
};

}  // namespace burnish
