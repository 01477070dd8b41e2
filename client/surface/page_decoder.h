#pragma once

#include <condition_variable>
#include <cstdint>
#include <deque>
#include <functional>
#include <mutex>
#include <set>
#include <span>
#include <stop_token>
#include <thread>
#include <vector>

#include "client/scene/page_mesh.h"
#include "common/pages/directory.h"

namespace burnish {

struct DecodedPage {
  PageId id = 0;
  Result<Page> page;
  PageMesh mesh;  ///< empty if the page failed
};

/// Decodes pages on a thread of its own, so that no picture waits. Used from one thread.
class PageDecoder {
 public:
  /// `on_news`: take() has something; called from the decoder's thread.
  PageDecoder(PageHead head, std::function<void()> on_news);

  /// Returns whether the page is in work, or has not been taken.
  bool has(PageId page) const { return known_.contains(page); }
  /// Returns whether more pages may be handed in: a later picture may want others.
  bool has_room() const { return known_.size() < kPagesMax; }

  /// Copies the bytes. Needs: has_room(), and the page is not in work.
  void decode(PageId page, std::span<const uint8_t> bytes);

  /// Returns the pages that are done since the last call.
  std::vector<DecodedPage> take();

 private:
  static constexpr size_t kPagesMax = 16;

  struct Job {
    PageId page;
    std::vector<uint8_t> bytes;
  };
  void run(const std::stop_token& stop);
  DecodedPage decode(const Job& job) const;

  const PageHead head_;
  const std::function<void()> on_news_;
  std::set<PageId> known_;

  std::mutex mutex_;  // guards the following members
  std::condition_variable_any changed_;
  std::deque<Job> jobs_;
  std::vector<DecodedPage> done_;

  std::jthread thread_;  // last member: it uses all the others
};

}  // namespace burnish
