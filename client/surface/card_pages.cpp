#include "client/surface/card_pages.h"

#include <algorithm>
#include <utility>

#include "client/scene/displaced_page.h"
#include "common/base/check.h"
#include "common/page_frames/page_corners.h"

namespace burnish {

CardPages::CardPages(const PageGrid& grid, int depth)
    : grid_(grid), depth_(depth), space_(make_page_space(grid, depth)) {}

Result<uint32_t> CardPages::open(PageRenderer& renderer, uint32_t slots) {
  renderer.open(space_);
  slots_.clear();
  slots = std::min(slots, kPageSlotsMax);
  for (;; slots /= 2) {
    const Status reserved = renderer.reserve(slots);
    if (reserved.is_ok()) break;
    if (slots < 2 * kSlotsMin) return reserved;
  }
  slots_.resize(slots);
  return slots;
}

Status CardPages::upload(PageRenderer& renderer, PageSlot slot, const Page& page,
                         std::shared_ptr<const PageMesh> mesh) {
  BURNISH_CHECK(slot < slots_.size(), "slots are reserved");
  slots_[slot] = {page.id, std::move(mesh), {}, nullptr, {}};
  slots_[slot].cells.reserve(page.positions.size());
  for (const Vec3i& position : page.positions)
    slots_[slot].cells.push_back(cell_place(position, grid_.bits, depth_).cell);
  return renderer.upload_page(slot, *slots_[slot].mesh);
}

Result<bool> CardPages::update(PageRenderer& renderer, std::span<const DrawnRange> drawn,
                               const SurfaceFrame& frame, const PageMarks& marks) {
  bool is_changed = false;
  PageSlot done = kPageSlotsMax;  // the ranges of a page follow each other
  for (const DrawnRange& range : drawn) {
    if (std::exchange(done, range.slot) == range.slot) continue;
    Slot& slot = slots_[range.slot];
    if (auto move = frame.share(slot.page); move != slot.moved) {
      RETURN_IF_ERROR(move_to(std::move(move), range.slot, renderer));
      is_changed = true;
    }
    if (!marks.update(slot.page, slot.cells, slot.mark)) continue;
    RETURN_IF_ERROR(renderer.mark_page(range.slot, slot.mark.marks));
    is_changed = true;
  }
  return is_changed;
}

Status CardPages::move_to(std::shared_ptr<const PageMove> move, PageSlot number,
                          PageRenderer& renderer) {
  BURNISH_CHECK(move != nullptr, "a drawn page is in the frame");
  Slot& slot = slots_[number];
  slot.moved = std::move(move);
  const MovedPage moved = displace(*slot.mesh, slot.moved->displacements, space_.cell_size);
  return renderer.move_page(number, slot.moved->displacements, moved);
}

std::optional<SurfaceHit> CardPages::hit(const PagePick& pick, const Ray& ray,
                                         bool original) const {
  const Slot& slot = slots_[pick.slot];
  DisplacedPage page{*slot.mesh, space_, {}};
  if (!original && slot.moved) page.displacements = slot.moved->displacements;
  return point_on_page_triangle(page, ray, pick.triangle);
}

}  // namespace burnish
