#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "client/live/live_link.h"
#include "client/pages/page_loader.h"
#include "client/pages/page_source.h"
#include "client/pages/picture_pace.h"
#include "client/scene/page_renderer.h"
#include "client/surface/card_pages.h"
#include "client/surface/page_decoder.h"
#include "client/surface/page_marks.h"
#include "client/surface/server_room.h"
#include "client/surface/shown_set.h"
#include "client/surface/texture_supply.h"
#include "common/base/clock.h"
#include "common/service/scan_pages.h"

namespace burnish {

/// A scan's pages, as far as a client knows them when it opens the scan.
struct OpenedPages {
  std::string scan;  ///< id
  PageHead head;
  uint64_t fingerprint = 0;  ///< pages_fingerprint() of the encoded head
  std::vector<std::pair<uint32_t, DirectoryBlock>> blocks;
};

/// Fails: data_loss that names the damage; unimplemented (another version).
Result<OpenedPages> open_pages(const PagesDescription& description, const std::string& scan);

struct SurfaceOptions {
  PageBudget budget;
  bool is_software = false;       ///< pictures are drawn without a graphics card
  std::function<void()> on_news;  ///< called from any thread: another look() helps
  Clock clock = std::chrono::steady_clock::now;
};

/// A session's surface as pictures show it: brings the pages that a picture needs to the card,
/// moves them by the frames of the session, and finds points on them. What is drawn is always a
/// whole surface at one moment. Never waits. Used from one thread.
class PagedSurface {
 public:
  /// Needs: `source` brings the scan's pages; `link` is the session's, of this depth, and outlives
  /// this.
  PagedSurface(OpenedPages pages, int depth, std::unique_ptr<PageSource> source, LiveLink& link,
               SurfaceOptions options);

  /// Empties the renderer for this surface. Call once, first. Needs: it outlives this.
  /// Fails: resource_exhausted.
  Status open(PageRenderer& renderer);

  /// Takes the newest frame of the link.
  void take(const LiveNews& news);
  /// Takes pages that have come, and decodes them. look() does so too.
  void take_arrivals();
  /// The link has come back: all that failed is asked for again.
  void on_link_made();

  /// Prepares the picture: chooses its pages, brings what has come to the card, and asks for the
  /// rest. `is_dragging`: a slider or curve moves the whole surface now.
  /// Fails: as the renderer does.
  Status look(const Camera& camera, const ImageSize& size, bool is_dragging);

  /// The picture of the last look() took so long, until the card had drawn it. Where that is long,
  /// pictures are coarser while something moves.
  void on_picture(double ms) { pace_.on_picture(loader_->cut().triangles, ms); }

  /// The patches that the last look() draws.
  std::span<const PatchRange> patches() const { return card_.patches(); }
  /// The pages of it, coarse before fine.
  const std::vector<PageId>& drawn_pages() const { return loader_->cut().visible_pages; }

  /// Returns the point of the last picture under the middle of a pixel.
  std::optional<SurfaceHit> hit_at(const Camera& camera, const ImageSize& size,
                                   const Eigen::Vector2i& pixel, bool original) const;

  /// Returns how many bytes of textures the renderer of open() has room for; 0: it shows none.
  uint64_t texture_bytes_max() const { return texture_bytes_max_; }
  /// Brings these sheets of the scan from the next look() on. Until the picture has those that it
  /// needs, pages without one show that of the last sheets. Needs: open().
  void set_textures(std::unique_ptr<TextureSupply> textures);
  /// Returns null: no sheets are shown.
  const TextureSupply* textures() const { return textures_.get(); }
  /// Returns whether the server said since the last call that it must make the sheets again.
  bool take_sheet_damage() { return std::exchange(lacks_sheets_, false); }
  /// Pictures show the scan's colours from the next look() on, or not; without a light they rest
  /// before full detail, for the texture has it.
  void show_scan_colours(bool shows, bool is_unlit) {
    shows_scan_colours_ = shows, is_unlit_ = is_unlit;
  }

  /// Frames carry colours from the next look() on, or no more. The last ones stay.
  void show_colours(bool shows) { shown_.show_colours(shows); }

  PageMarks& marks() { return marks_; }
  StrokeTint& tint() { return tint_; }
  bool is_tinted() const { return !tint_.is_clear(); }
  /// Returns nothing for a page that is not in memory.
  std::optional<size_t> vertex_count(PageId page) const;

  CutStatus status() const { return loader_->status(); }
  /// Returns a number that rises when look() changes the picture.
  uint64_t changes() const { return changes_; }
  /// Returns whether the next look() with the same arguments changes nothing, until on_news.
  bool is_settled() const;
  /// Returns whether the picture of the last look() has each texel that one at rest needs.
  bool has_all_texels() const { return !shows_textures() || textures_->has_all(); }
  /// Returns why the server must make the pages again, if it said so since the last call.
  std::optional<Status> take_damage() { return std::exchange(damage_, std::nullopt); }
  /// The server has made the pages again: all that failed is asked for again.
  void on_pages_renewed() { on_link_made(); }
  /// Returns what could not be fetched since the last call, in words; empty: nothing.
  std::string take_failures();

  const PageHead& head() const { return pages_.head; }
  uint64_t pages_fingerprint() const { return pages_.fingerprint; }
  const std::function<void()>& on_news() const { return options_.on_news; }

 private:
  void hand_in_block(uint32_t number, Result<std::vector<uint8_t>> bytes);
  void start_decoding();
  void ask_for_items();
  Status put_on_card();
  Status show_pages();
  Status show_frame();
  Status show_textures(std::span<const DrawnRange> drawn);
  std::shared_ptr<const PageTexture> texture(PageId page) const;
  void take_sheet_arrival(PageSource::Arrival arrival);
  bool shows_textures() const { return textures_ != nullptr && shows_scan_colours_; }
  PictureQuestion question(const Camera& camera, const ImageSize& size, bool is_dragging) const;
  FrameBounds frame_bounds() const;
  uint64_t vertices_in_flight_max() const;
  bool moves(bool is_dragging) const;

  OpenedPages pages_;
  LiveLink& link_;
  SurfaceOptions options_;
  double cell_size_;  // file units
  StrokeTint tint_;
  PageMarks marks_;
  CardPages card_;
  ShownSet shown_;
  ServerRoom room_;
  uint64_t server_vertices_max_ = 0;  // of the last look()
  uint64_t refusals_ = 0;
  std::unique_ptr<PageLoader> loader_;
  std::unordered_map<PageId, PageMesh> meshes_;  // of decoded pages that are not on the card

  std::shared_ptr<const SurfaceFrame> frame_;
  LinkStats stats_;
  PicturePace pace_;
  uint64_t changes_ = 0;
  std::optional<Status> damage_;

  uint64_t texture_bytes_max_ = 0;
  bool lacks_sheets_ = false;
  bool shows_scan_colours_ = false;
  bool is_unlit_ = false;
  std::unique_ptr<TextureSupply> textures_;       // null: the scan has none, or none is known yet
  std::unique_ptr<TextureSupply> last_textures_;  // until textures_ are settled; else null

  std::unique_ptr<PageSource> source_;  // their threads call on_news
  PageDecoder decoder_;
};

}  // namespace burnish
