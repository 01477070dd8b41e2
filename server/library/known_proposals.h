#pragma once

#include <map>
#include <mutex>
#include <optional>
#include <string>

#include "common/edit/proposed_edges.h"

namespace burnish {

/// The proposals that scans have got. An id names the bytes of a scan, so none ever changes.
/// Thread-safe.
class KnownProposals {
 public:
  /// Beyond so many any one is forgotten.
  static constexpr size_t kProposalsMax = 1000;

  std::optional<EdgeProposal> find(const std::string& scan_id) const {
    const std::lock_guard lock(mutex_);
    const auto found = proposals_.find(scan_id);
    return found == proposals_.end() ? std::nullopt : std::optional(found->second);
  }

  void add(const std::string& scan_id, const EdgeProposal& proposal) {
    const std::lock_guard lock(mutex_);
    if (proposals_.size() >= kProposalsMax) proposals_.erase(proposals_.begin());
    proposals_[scan_id] = proposal;
  }

 private:
  mutable std::mutex mutex_;
  std::map<std::string, EdgeProposal> proposals_;
};

}  // namespace burnish
