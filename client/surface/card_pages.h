#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "client/live/surface_frame.h"
#include "client/pages/drawn_ranges.h"
#include "client/scene/page_surface.h"
#include "client/scene/surface_hit.h"
#include "client/surface/page_marks.h"

namespace burnish {

/// The pages in a renderer's slots: puts them there, moves and marks those that are drawn, and
/// finds points on them. A page that is not drawn is brought up to date when it is drawn again.
class CardPages {
 public:
  CardPages(const PageGrid& grid, int depth);

  /// Begins with an empty renderer that has room for `slots` pages; takes fewer if the card has
  /// no room, and returns how many. Fails: resource_exhausted if there is no room for kSlotsMin.
  /// Needs: the renderer outlives this object.
  Result<uint32_t> open(PageRenderer& renderer, uint32_t slots);

  Status put(PageSlot slot, const Page& page, PageMesh mesh);

  /// Brings the drawn pages to this frame and these marks, and returns whether any changed. All are
  /// of one moment, so that no crack opens. Needs: the frame has all drawn pages.
  Result<bool> show(std::span<const DrawnRange> drawn, const SurfaceFrame& frame,
                    const PageMarks& marks);

  /// Gives the pages of all slots the textures that `texture_of` returns; null: none.
  /// Returns whether any changed. Fails: resource_exhausted.
  Result<bool> show_textures(
      const std::function<std::shared_ptr<const PageTexture>(PageId)>& texture_of);

  /// The patches that the last show() has to draw.
  std::span<const PatchRange> patches() const { return patches_; }

  /// Returns the first point of what the last show() shows, or of its original, on the ray.
  std::optional<SurfaceHit> hit(const Ray& ray, bool original) const;

  static constexpr uint32_t kSlotsMin = 64;

 private:
  struct Slot {
    PageId page = kNoPage;
    std::vector<Vec3i> cells;                    // of the vertices, grid units
    std::shared_ptr<const PageMove> moved;       // as the renderer has it
    PageMarks::Mark mark;                        // likewise
    std::shared_ptr<const PageMove> coloured;    // likewise
    std::shared_ptr<const PageMove> gains;       // likewise; null: of 1
    std::shared_ptr<const PageTexture> texture;  // likewise; null: none
  };
  bool list_patches(std::span<const DrawnRange> drawn);
  bool move_to(std::shared_ptr<const PageMove> move, PageSlot slot);
  Result<bool> colour_as(const SurfaceFrame& frame, const DrawnRange& range);
  Result<bool> mark_as(const PageMarks& marks, PageSlot slot);

  PageGrid grid_;
  int depth_;
  PageRenderer* renderer_ = nullptr;
  std::optional<PageSurface> surface_;
  std::vector<Slot> slots_;
  std::vector<PatchRange> patches_;
};

}  // namespace burnish
