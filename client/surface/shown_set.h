#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <unordered_map>
#include <vector>

#include "client/live/surface_frame.h"
#include "client/pages/chosen_cut.h"
#include "client/pages/page_cache.h"

namespace burnish {

/// Decides which pages the frames of a live session carry: those of which the picture is made, and
/// those that will make it finer. Removes pages late, because a camera comes back. Colours, and the
/// gains of texels, come as pages of their own, where pictures show them.
class ShownSet {
 public:
  struct Change {
    std::vector<std::shared_ptr<const Page>> added;
    std::vector<PageId> removed;
    bool is_empty() const { return added.empty() && removed.empty(); }
  };

  /// Returns what to change for this picture. New pages come as whole keys, so on a slow link only
  /// as many vertices are added as fit `vertices_in_flight_max`, the most urgent first; 0: any
  /// number. Removes at once above `server_vertices_max`, as vertex_count() counts; 0: no limit.
  /// `frame` may be null.
  Change change(const ChosenCut& cut, const PageCache& cache, const SurfaceFrame* frame,
                uint64_t vertices_in_flight_max, uint64_t server_vertices_max = 0);

  /// Shows colours from the next change() on, or no more.
  void show_colours(bool shows) { shows_colours_ = shows; }
  /// Shows gains beside the colours, or no more. Needs: a server that has sheets.
  void show_gains(bool shows) { shows_gains_ = shows; }
  /// Returns how often a server counts the vertices of a page: its colours and gains count again.
  uint64_t copies() const { return 1 + extras().size(); }

  size_t page_count() const { return shown_.size(); }
  uint64_t vertex_count() const;

 private:
  void add(const ChosenCut& cut, const PageCache& cache, const SurfaceFrame* frame,
           uint64_t vertices_in_flight_max, Change& change);
  /// Returns what stands for pages of colours and gains that are shown.
  std::vector<PageId> extras() const;
  void add_extra(PageId extra, const ChosenCut& cut, const PageCache& cache, Change& change);
  void remove(const ChosenCut& cut, uint64_t server_vertices_max, Change& change);

  bool shows_colours_ = false, shows_gains_ = false;
  std::unordered_map<PageId, uint32_t> shown_;  // vertices by page
};

}  // namespace burnish
