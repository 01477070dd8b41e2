#include "client/surface/card_pages.h"

#include <algorithm>
#include <utility>

#include "common/base/check.h"
#include "common/base/limits.h"
#include "common/mesh/srgb.h"
#include "common/page_frames/page_corners.h"
#include "common/page_frames/shown_pages.h"

namespace burnish {

/// Gives a page's colours the change of a frame. Without gains texels change as their vertices.
static Status colour_page(PageRenderer& renderer, PageSlot number, std::span<const Rgba8> before,
                          const PageMove& change, const PageMove* gains) {
  std::vector<Rgba8> colours(before.begin(), before.end());
  std::vector<TexelChange> texels(before.size());
  for (size_t v = 0; v < colours.size(); ++v) {
    const Vec3f light = change.displacements[v] / kCellsPerColour;
    const float gain = gains ? 1 + gains->displacements[v].x() / kCellsPerColour : 1;
    colours[v] = changed_colour(before[v], light);
    texels[v] = texel_change(before[v], light, gain);
  }
  return renderer.colour_page(number, colours, texels);
}

CardPages::CardPages(const PageGrid& grid, int depth) : grid_(grid), depth_(depth) {}

Result<uint32_t> CardPages::open(PageRenderer& renderer, uint32_t slots) {
  renderer_ = &renderer;
  surface_.emplace(renderer);
  surface_->open(make_page_space(grid_, depth_));
  patches_.clear();
  slots_.clear();
  slots = std::min(slots, kPageSlotsMax);
  for (;; slots /= 2) {
    const Status reserved = surface_->reserve(slots);
    if (reserved.is_ok()) break;
    if (slots < 2 * kSlotsMin) return reserved;
  }
  slots_.resize(slots);
  return slots;
}

Status CardPages::put(PageSlot slot, const Page& page, PageMesh mesh) {
  BURNISH_CHECK(slot < slots_.size(), "slots are reserved");
  slots_[slot] = {page.id, {}, nullptr, {}, nullptr, nullptr, nullptr};
  slots_[slot].cells.reserve(page.positions.size());
  for (const Vec3i& position : page.positions)
    slots_[slot].cells.push_back(cell_place(position, grid_.bits, depth_).cell);
  return surface_->put(slot, std::move(mesh));
}

Result<bool> CardPages::show(std::span<const DrawnRange> drawn, const SurfaceFrame& frame,
                             const PageMarks& marks) {
  bool is_changed = list_patches(drawn);
  PageSlot done = kPageSlotsMax;  // the ranges of a page follow each other
  for (const DrawnRange& range : drawn) {
    if (std::exchange(done, range.slot) == range.slot) continue;
    is_changed |= move_to(frame.share(range.page), range.slot);
    ASSIGN_OR_RETURN(const bool is_coloured, colour_as(frame, range));
    ASSIGN_OR_RETURN(const bool is_marked, mark_as(marks, range.slot));
    is_changed |= is_marked || is_coloured;
  }
  RETURN_IF_ERROR(surface_->show(patches_));
  return is_changed;
}

bool CardPages::list_patches(std::span<const DrawnRange> drawn) {
  std::vector<PatchRange> patches;
  patches.reserve(drawn.size());
  for (const DrawnRange& range : drawn)
    patches.push_back({range.slot, range.first_triangle, range.triangles});
  if (patches == patches_) return false;
  patches_ = std::move(patches);
  return true;
}

bool CardPages::move_to(std::shared_ptr<const PageMove> move, PageSlot number) {
  BURNISH_CHECK(move != nullptr, "a drawn page is in the frame");
  Slot& slot = slots_[number];
  if (slot.moved == move) return false;
  slot.moved = std::move(move);
  surface_->move(number, slot.moved->displacements);
  return true;
}

// Without a change in the frame the last colours stay.
Result<bool> CardPages::colour_as(const SurfaceFrame& frame, const DrawnRange& range) {
  Slot& slot = slots_[range.slot];
  const auto change = frame.share(range.page | kColourPages);
  const auto gains = frame.share(range.page | kGainPages);
  if (change == nullptr || (slot.coloured == change && slot.gains == gains)) return false;
  slot.coloured = change;
  slot.gains = gains;
  const std::vector<Rgba8>& before = surface_->at(range.slot).mesh.colours;
  RETURN_IF_ERROR(colour_page(*renderer_, range.slot, before, *change, gains.get()));
  return true;
}

Result<bool> CardPages::mark_as(const PageMarks& marks, PageSlot number) {
  Slot& slot = slots_[number];
  if (!marks.update(slot.page, slot.cells, slot.mark)) return false;
  RETURN_IF_ERROR(renderer_->mark_page(number, slot.mark.marks));
  return true;
}

Result<bool> CardPages::show_textures(
    const std::function<std::shared_ptr<const PageTexture>(PageId)>& texture_of) {
  bool is_changed = false;
  for (PageSlot number = 0; number < slots_.size(); ++number) {
    Slot& slot = slots_[number];
    if (slot.page == kNoPage) continue;
    std::shared_ptr<const PageTexture> texture = texture_of(slot.page);
    if (slot.texture == texture) continue;
    slot.texture = texture;
    RETURN_IF_ERROR(renderer_->texture_page(number, std::move(texture)));
    is_changed = true;
  }
  return is_changed;
}

std::optional<SurfaceHit> CardPages::hit(const Ray& ray, bool original) const {
  const auto found = surface_->hit(ray, original);
  if (!found) return std::nullopt;
  SurfaceHit point = found->point;
  const auto& values = slots_[found->slot].mark.values;
  if (values == nullptr) return point;
  const auto& triangle = surface_->at(found->slot).mesh.triangles[point.triangle];
  for (int i = 0; i < 3; ++i) point.mark += point.weights[i] * (*values)[triangle[i]];
  return point;
}

}  // namespace burnish
