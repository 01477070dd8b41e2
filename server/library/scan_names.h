#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "common/base/status.h"
#include "server/library/scan_index.h"

namespace burnish {

/// Fails: already_exists that names one of `others` whose name looks like that of `scan`, which may
/// be among them.
Status check_name_is_free(const ScanInfo& scan, const std::vector<ScanInfo>& others);

/// The names of scans, each given once: a reference must not change its meaning because somebody
/// imports. Knows what this server knows; the catalogue of a fleet refuses what another server has
/// given at the same moment. Thread-safe.
class ScanNames {
 private:
  struct State {
    std::mutex mutex;
    struct Given {
      std::string id;
      int holds = 0;
    };
    std::map<std::string, Given> given;  // by the looks of the names that are held
  };

 public:
  /// A name that no other scan gets while this lives.
  class Hold {
   public:
    Hold(std::shared_ptr<State> state, std::string name, std::string look)
        : state_(std::move(state)), name_(std::move(name)), look_(std::move(look)) {}
    Hold(Hold&&) noexcept = default;
    Hold& operator=(Hold&&) = delete;
    ~Hold();

    const std::string& name() const { return name_; }

   private:
    std::shared_ptr<State> state_;  // null: moved away
    std::string name_;
    std::string look_;
  };

  /// Needs: `index` outlives this.
  explicit ScanNames(const ScanIndex& index) : index_(index) {}

  /// Holds a name for the scan `id` until the index has it. Unless it must be `exact`, it becomes
  /// numbered_scan_name(), and another one than those that are held. Fails: invalid_argument, as
  /// check_scan_name(); already_exists that names the scan that has the name, or one that looks
  /// like it.
  Result<Hold> hold(const std::string& id, const std::string& name, bool exact);

 private:
  const ScanIndex& index_;
  const std::shared_ptr<State> state_ = std::make_shared<State>();
};

}  // namespace burnish
