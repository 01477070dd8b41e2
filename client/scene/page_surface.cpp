#include "client/scene/page_surface.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "client/scene/page_normals.h"
#include "client/scene/ridges.h"
#include "common/base/check.h"

namespace burnish {

void PageSurface::open(const PageSpace& space) {
  renderer_.open(space);
  space_ = space;
  slots_.assign(slots_.size(), {});
  has_new_pages_ = true;
  drawn_.clear();
  shared_ = {};
}

Status PageSurface::reserve(uint32_t slots) {
  RETURN_IF_ERROR(renderer_.reserve(slots));
  if (slots > slots_.size()) slots_.resize(slots);
  return Status::ok();
}

Status PageSurface::put(uint32_t slot, PageMesh mesh) {
  BURNISH_CHECK(slot < slots_.size(), "slots are reserved");
  has_new_pages_ = true;
  slots_[slot] = {};
  RETURN_IF_ERROR(renderer_.upload_page(slot, mesh));
  slots_[slot].mesh = std::move(mesh);
  return Status::ok();
}

void PageSurface::move(uint32_t slot, std::vector<Vec3f> displacements) {
  BURNISH_CHECK(slot < slots_.size(), "slots are reserved");
  BURNISH_CHECK(displacements.size() == slots_[slot].mesh.positions.size(),
                "one displacement per vertex");
  slots_[slot].displacements = std::move(displacements);
  slots_[slot].is_stale = true;
}

static std::vector<PatchRange> by_slot(std::span<const PatchRange> patches) {
  std::vector<PatchRange> sorted(patches.begin(), patches.end());
  std::ranges::sort(sorted, {}, [](const PatchRange& p) { return std::tuple(p.slot, p.first); });
  return sorted;
}

// Notes which slots are drawn in another way than before.
void PageSurface::take(std::span<const PatchRange> patches) {
  std::vector<PatchRange> sorted = by_slot(patches);
  if (!std::exchange(has_new_pages_, false) && sorted == patches_) return;
  patches_ = std::move(sorted);
  std::vector<uint32_t> drawn;
  for (size_t first = 0, end = 0; first < patches_.size(); first = end) {
    const uint32_t number = patches_[first].slot;
    BURNISH_CHECK(number < slots_.size(), "slots are reserved");
    while (end < patches_.size() && patches_[end].slot == number) ++end;
    const auto ranges = std::span(patches_).subspan(first, end - first);
    drawn.push_back(number);
    Slot& slot = slots_[number];
    const PatchRange& last = ranges.back();
    BURNISH_CHECK(size_t{last.first} + last.count <= slot.mesh.triangles.size(),
                  "patches lie inside the page in their slot");
    if (std::ranges::equal(slot.drawn, ranges)) continue;
    slot.drawn.assign(ranges.begin(), ranges.end());
    slot.rim = find_rim(slot.mesh, ranges);
    slot.still_sums = sum_rim_normals(slot.mesh.positions, slot.mesh, ranges, slot.rim);
    slot.is_stale = true;
  }
  forget_undrawn(drawn);
  drawn_ = std::move(drawn);
  find_rims();
}

void PageSurface::forget_undrawn(const std::vector<uint32_t>& drawn) {
  for (const uint32_t number : drawn_) {
    if (std::ranges::binary_search(drawn, number)) continue;
    slots_[number].drawn.clear();
    slots_[number].moved = {};
  }
}

void PageSurface::find_rims() {
  std::vector<RimmedPage> pages;
  for (const uint32_t number : drawn_) pages.push_back({&slots_[number].mesh, &slots_[number].rim});
  shared_ = group_rims(pages);
}

// Moves a page by itself.
void PageSurface::refresh(Slot& slot) const {
  slot.is_sent = slot.is_at_rest && slot.displacements.empty();
  if (slot.displacements.empty()) {
    slot.moved = {slot.mesh.positions, slot.mesh.normals};
    slot.moved_sums = slot.still_sums;
    return;
  }
  slot.moved = displace(slot.mesh, slot.displacements, space_.cell_size);
  slot.moved_sums = sum_rim_normals(slot.moved.positions, slot.mesh, slot.drawn, slot.rim);
}

// Turns the normals of one lattice point in all pages that have it.
void PageSurface::join(std::span<const RimPlace> group) {
  const auto slot_of = [&](const RimPlace& place) -> Slot& { return slots_[drawn_[place.page]]; };
  if (std::ranges::none_of(group, [&](const auto& place) { return slot_of(place).is_stale; }))
    return;
  Vec3f still = Vec3f::Zero(), moved = Vec3f::Zero();
  for (const RimPlace& place : group) {
    still += slot_of(place).still_sums[place.index];
    moved += slot_of(place).moved_sums[place.index];
  }
  for (const RimPlace& place : group) {
    Slot& slot = slot_of(place);
    const uint16_t vertex = slot.rim[place.index];
    const Vec3f turned = turned_normal(slot.mesh.normals[vertex], still, moved);
    if (slot.moved.normals[vertex] == turned) continue;
    slot.moved.normals[vertex] = turned;
    slot.is_sent = false;
  }
}

Status PageSurface::send(uint32_t number) {
  Slot& slot = slots_[number];
  slot.is_stale = false;
  if (slot.is_sent) return Status::ok();
  const bool is_moved = !slot.displacements.empty();
  const std::vector<Vec3f> nowhere(is_moved ? 0 : slot.mesh.positions.size(), Vec3f::Zero());
  const auto& [positions, normals] = slot.moved;
  RETURN_IF_ERROR(renderer_.move_page(number, is_moved ? slot.displacements : nowhere, normals,
                                      vertex_ridges(positions, normals, slot.mesh.triangles)));
  slot.is_sent = true;
  slot.is_at_rest = false;
  return Status::ok();
}

Status PageSurface::draw(const Camera& camera, const ImageSize& size, const DrawStyle& style,
                         std::span<const PatchRange> patches) {
  take(patches);
  for (const uint32_t number : drawn_)
    if (slots_[number].is_stale) refresh(slots_[number]);
  for (size_t group = 0; group < shared_.count(); ++group) join(shared_[group]);
  for (const uint32_t number : drawn_) RETURN_IF_ERROR(send(number));
  return renderer_.draw(camera, size, style, patches);
}

}  // namespace burnish
