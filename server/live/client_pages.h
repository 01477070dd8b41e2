#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "common/service/live.h"
#include "server/live/page_source.h"

namespace burnish {

/// The pages that one client shows at a revision. Immutable.
struct ClientPages {
  PageFrameKind kind = PageFrameKind::kVertices;
  bool knows_held = false;  ///< frames may name the vertices that stay
  bool insists = false;     ///< the client takes no other kind
  ShownPages shown;
  std::vector<std::shared_ptr<const LivePage>> pages;  ///< one per shown page, in its order
};

/// Returns the kind for pages of this size. A free choice takes the cheaper kind; later the other
/// kind must be cheaper by a third, since its frames begin with a key.
PageFrameKind choose_kind(std::optional<PageFrameKind> present, uint64_t vertices,
                          uint64_t corners);

/// A client's wish for pages, and what is made of it. It remembers the newest wish alone, however
/// fast wishes come. Thread-safe; one thread at a time makes pages.
class PageWishes {
 public:
  /// `greeting`: names the kind that the client insists on. `memory`: of the client's lists and
  /// frames.
  PageWishes(std::shared_ptr<ScanPageSource> source, const Greeting& greeting, Quota::Share memory);

  /// Checks and notes a change. Returns true if somebody must now call make_some(), until that
  /// returns false. Fails: as ShownPages::check(); resource_exhausted (kPageChangesInFlightMax, or
  /// the server's memory has no room for the list).
  Result<bool> want(const ShowPages& change);

  /// Says whether vertices move otherwise than their corners say. Then pages are of kind kVertices,
  /// unless the client insists on the other one. Returns as want() does.
  bool set_layer(bool is_there);

  /// Makes some of the wanted pages; made() has the newest revision as soon as it has all of them.
  /// Returns whether more is to do. Takes some milliseconds. Fails: as
  /// ScanPageSource::find_or_make().
  Result<bool> make_some();

  /// Returns what to show: at first nothing, at revision 0.
  std::shared_ptr<const ClientPages> made() const;

  /// Returns whether the client shows nothing yet, but soon will.
  bool is_beginning() const;

  /// Gives memory back that earlier pages needed. `bytes`: what the client's encoder holds.
  void note_encoder_bytes(uint64_t bytes);

  uint64_t byte_count() const;  ///< of the list of wanted pages

 private:
  using Loaded = std::map<PageId, std::shared_ptr<const LivePage>>;

  Status load(const ShownPages& wanted, bool& is_whole);
  PageFrameKind choose(bool has_layer) const;
  ClientPages gather(const ShownPages& wanted) const;
  Result<bool> publish(ClientPages pages, bool has_layer);
  Status grow(uint64_t bytes);

  const std::shared_ptr<ScanPageSource> source_;
  const std::optional<PageFrameKind> insisted_;
  const bool knows_held_;
  // Used by make_some() only.
  PageFrameKind kind_;
  Loaded loaded_;

  mutable std::mutex mutex_;  // guards the following members
  ShownPages wanted_;         // numbers alone, without layouts
  bool has_layer_ = false;
  bool is_making_ = false;
  std::shared_ptr<const ClientPages> made_;
  Quota::Share memory_;
};

}  // namespace burnish
