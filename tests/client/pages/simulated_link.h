#pragma once

#include <chrono>
#include <cstdint>
#include <deque>
#include <map>
#include <set>
#include <vector>

#include "client/pages/page_loader.h"
#include "tests/client/pages/synthetic_scan.h"

namespace burnish {

/// What a link does wrong, each as a part of the items: from 0 to 1.
struct LinkFaults {
  double lost = 0;        ///< never come
  double failed = 0;      ///< refused at once
  double damaged = 0;     ///< do not decode
  double cut_short = 0;   ///< miss their last byte
  double doubled = 0;     ///< come twice
  double late = 0;        ///< come up to a second late, after others
  double wrong_size = 0;  ///< decode to another number of triangles
};

struct SimulatedLinkOptions {
  LinkSpeed speed = {6.25e6, 0.04};  ///< 50 Mbit/s
  LinkFaults faults;
  uint64_t seed = 1;
};

/// A server and the link to it, in simulated time. Brings pages and blocks in the order asked, one
/// behind the other. Fails the test when something is asked for that is on its way.
class SimulatedLink {
 public:
  using Time = PageLoader::Time;

  SimulatedLink(const SyntheticScan& scan, const SimulatedLinkOptions& options)
      : scan_(scan), options_(options) {}

  void ask(const PageRequests::Plan& plan, Time now);
  /// Hands in what has come by now.
  void deliver(PageLoader& loader, Time now);
  /// Stands for decode_page() on bytes that this link brought.
  Result<Page> decode(PageId page, std::span<const uint8_t> bytes) const;

  void set_faults(const LinkFaults& faults) { options_.faults = faults; }
  void set_broken(bool broken) { broken_ = broken; }
  /// Loses what is on its way.
  void forget() { coming_.clear(), asked_.clear(); }

  uint64_t bytes_asked() const { return bytes_asked_; }
  size_t on_their_way() const { return asked_.size(); }

 private:
  enum class Fate { kGood, kFailed, kDamaged, kCutShort, kWrongSize };
  struct Arrival {
    PageItem item;
    Fate fate;
  };

  double draw();
  uint32_t bytes_of(PageItem item) const;
  void send(PageItem item, Time now);
  void bring(PageLoader& loader, const Arrival& arrival, Time now);
  void bring_block(PageLoader& loader, const Arrival& arrival, Time now);

  const SyntheticScan& scan_;
  SimulatedLinkOptions options_;
  std::multimap<Time, Arrival> coming_;
  std::set<PageItem> asked_;
  Time free_at_ = {};
  uint64_t draws_ = 0;
  uint64_t bytes_asked_ = 0;
  bool broken_ = false;
};

}  // namespace burnish
