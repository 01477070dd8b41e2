#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "client/pages/chosen_cut.h"
#include "client/pages/cut_chooser.h"
#include "client/pages/cut_status.h"
#include "client/pages/known_pages.h"
#include "client/pages/page_cache.h"
#include "client/pages/page_requests.h"
#include "common/base/status.h"

namespace burnish {

/// The request of a picture.
struct PictureQuestion {
  PageView view;
  FrameBounds frame;
  bool surface_moves = false;  ///< frames come, or are about to
  /// The most values that a frame may have while the surface moves; 0 is unknown.
  uint64_t frame_vertices_max = 0;
  /// The most vertices that the server has memory for; 0: any number.
  uint64_t server_vertices_max = 0;
  /// Whether the shown frame has a page's values. Empty: no frame moves the surface.
  std::function<bool(PageId)> has_values;
  /// The most triangles of a picture that others follow at once (PicturePace); 0: any number.
  uint64_t moving_triangles_max = 0;
  /// A picture at rest stays as fine as one whose camera moves: a texture has its detail.
  bool rests_early = false;
  LinkSpeed link;
};

struct PageUpload {
  PageId page = 0;
  PageSlot slot = 0;
  std::shared_ptr<const Page> content;
};

/// Brings the pages of a scan from a server to the card, as pictures need them. Knows no network
/// and no OpenGL: both are told what to do, and tell what they did. For one thread.
///
/// For each picture: look(), carry out requests() and take_uploads(), then draw cut(). In between:
/// hand in what came, and decode what to_decode() lists.
class PageLoader {
 public:
  using Time = PageRequests::Time;

  PageLoader(PageHead head, const PageBudget& budget, bool is_software);
  PageLoader(const PageLoader&) = delete;
  PageLoader& operator=(const PageLoader&) = delete;

  /// Chooses the picture's cut. The result stays until the next call.
  const ChosenCut& look(const PictureQuestion& question, Time now);

  const ChosenCut& cut() const { return chooser_.cut(); }
  const PageRequests::Plan& requests() const { return requests_.plan(); }
  /// Returns held pages that the picture wants, the most urgent first.
  const std::vector<PageId>& to_decode() const { return to_decode_; }
  /// Needs: a page of to_decode(), before the next look().
  std::span<const uint8_t> bytes_of(PageId page) const;
  /// Returns pages that have a new slot since the last call. The caller fills their slots before it
  /// draws the next cut.
  std::vector<PageUpload> take_uploads();
  /// Returns what was given up since the last call.
  std::vector<GivenUpItem> take_given_up() { return requests_.failures().take_news(); }

  /// Items that came, asked for or not: what nobody needs is dropped.
  void on_block(uint32_t index, Result<DirectoryBlock> block, Time now);
  void on_page(PageId page, std::vector<uint8_t> bytes, Time now);
  /// Needs: a page in the result passed check_page_in_scan().
  void on_decoded(PageId id, Result<Page> page, Time now);
  /// The server refused an item, or its call broke.
  void on_failure(PageItem item, const Status& why, Time now);
  void on_link_lost() { requests_.on_link_lost(); }
  /// A new connection: all that failed is asked for again.
  void on_link_made() { requests_.failures().clear(); }

  CutStatus status() const;
  /// Returns whether another look() with the same question would change nothing.
  bool is_settled() const;

  /// Returns whether the last picture shows all pages that it wants at once.
  bool is_prompt() const { return wants_full_ || (needs_.open_in_view == 0 && !lacks_values_); }
  /// Returns whether view and surface are those of the picture before the last.
  bool is_at_rest() const { return is_at_rest_; }

  // Those of the last look().
  const PageView& view() const { return view_; }
  const FrameBounds& frame() const { return frame_; }

  const KnownPages& known() const { return known_; }
  const PageCache& cache() const { return cache_; }
  const PageRequests& in_flight() const { return requests_; }

 private:
  /// The needs of the picture's cut. Items that were given up do not count.
  struct Needs {
    std::vector<MissingItem> missing;
    std::vector<MissingItem> held;
    std::vector<MissingItem> decoded;
    size_t open = 0;             ///< items that are not on the card
    size_t open_in_view = 0;     ///< those of them that may be in the picture
    uint64_t bytes_left = 0;     ///< to load, for the picture
    uint64_t failed = 0;         ///< given up, for the picture
    size_t blocks_left_out = 0;  ///< more than the directory's budget
  };

  void see(const PictureQuestion& question, Time now);
  CutQuestion cut_question(const PictureQuestion& question) const;
  const Page* find_ready(PageId page, const PictureQuestion& question);
  void take_stock();
  void take_stock_of(const WantedPage& wanted);
  void miss(const MissingItem& missing, bool is_seen);
  void put_on_card();
  bool make_room_for_blocks(size_t count);
  bool place(PageId page);
  bool is_wanted(PageItem item) const;
  CutReason reason() const;

  PageBudget budget_;
  bool is_software_;
  KnownPages known_;
  CutChooser chooser_;
  PageCache cache_;
  PageRequests requests_;
  Needs needs_;
  std::vector<PageId> to_decode_;
  std::vector<PageId> uploads_;

  PageView view_;  ///< of the last look()
  FrameBounds frame_;
  bool has_looked_ = false;
  Time moved_at_{};  ///< when view, frame or surface were new last
  bool is_at_rest_ = false;
  bool wants_full_ = false;
  bool lacks_values_ = false;
  bool is_server_limit_ = false;  ///< the budget of vertices is the server's
};

}  // namespace burnish
