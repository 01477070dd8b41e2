#include "client/scene/page_surface.h"

#include <algorithm>
#include <limits>
#include <tuple>
#include <utility>

#include "client/scene/page_normals.h"
#include "client/scene/ray_box.h"
#include "common/base/check.h"
#include "common/base/heap_sort.h"

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

static Eigen::AlignedBox3f box_of(std::span<const Vec3f> positions,
                                  std::span<const Vec3f> displacements, float cell_size) {
  Eigen::AlignedBox3f box;
  for (size_t v = 0; v < positions.size(); ++v)
    box.extend(displacements.empty() ? positions[v]
                                     : Vec3f(positions[v] + cell_size * displacements[v]));
  return box;
}

Status PageSurface::put(uint32_t slot, PageMesh mesh) {
  BURNISH_CHECK(slot < slots_.size(), "slots are reserved");
  has_new_pages_ = true;
  slots_[slot] = {};
  RETURN_IF_ERROR(renderer_.upload_page(slot, mesh));
  slots_[slot].mesh = std::move(mesh);
  slots_[slot].box = slots_[slot].moved_box = box_of(slots_[slot].mesh.positions, {}, 0);
  return Status::ok();
}

void PageSurface::move(uint32_t slot, std::vector<Vec3f> displacements) {
  BURNISH_CHECK(slot < slots_.size(), "slots are reserved");
  BURNISH_CHECK(displacements.size() == slots_[slot].mesh.positions.size(),
                "one displacement per vertex");
  slots_[slot].moved_box = box_of(slots_[slot].mesh.positions, displacements, space_.cell_size);
  slots_[slot].displacements = std::move(displacements);
  slots_[slot].is_stale = true;
}

static std::vector<PatchRange> by_slot(std::span<const PatchRange> patches) {
  std::vector<PatchRange> sorted(patches.begin(), patches.end());
  heap_sort(sorted, {}, [](const PatchRange& p) { return std::tuple(p.slot, p.first); });
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
    begin(number, std::span(patches_).subspan(first, end - first));
    drawn.push_back(number);
  }
  forget_undrawn(drawn);
  drawn_ = std::move(drawn);
  find_rims();
}

void PageSurface::begin(uint32_t number, std::span<const PatchRange> patches) {
  Slot& slot = slots_[number];
  const PatchRange& last = patches.back();
  BURNISH_CHECK(size_t{last.first} + last.count <= slot.mesh.triangles.size(),
                "patches lie inside the page in their slot");
  if (std::ranges::equal(slot.shown.patches, patches)) return;
  slot.shown = begin_drawing(slot.mesh, patches);
  slot.is_stale = true;
}

void PageSurface::forget_undrawn(const std::vector<uint32_t>& drawn) {
  for (const uint32_t number : drawn_) {
    if (std::ranges::binary_search(drawn, number)) continue;
    slots_[number].shown = {};
  }
}

void PageSurface::find_rims() {
  std::vector<RimmedPage> pages;
  for (const uint32_t number : drawn_)
    pages.push_back({&slots_[number].mesh, &slots_[number].shown.rim});
  shared_ = group_rims(pages);
}

void PageSurface::refresh(Slot& slot) const {
  if (!slot.is_stale) return;
  move_drawn_page(slot.shown, slot.mesh, slot.displacements, space_.cell_size);
  slot.is_bent = true;
  slot.is_sent = slot.is_at_rest && slot.displacements.empty();
}

// Turns the normals of one lattice point in all pages that have it.
void PageSurface::join_normals(Group group) {
  if (std::ranges::none_of(group, [&](const auto& place) { return slot_of(place).is_stale; }))
    return;
  Vec3f still = Vec3f::Zero(), moved = Vec3f::Zero();
  for (const RimPlace& place : group) {
    still += slot_of(place).shown.still_sums[place.index];
    moved += slot_of(place).shown.moved_sums[place.index];
  }
  for (const RimPlace& place : group) {
    Slot& slot = slot_of(place);
    const uint16_t vertex = slot.shown.rim[place.index];
    const Vec3f turned = turned_normal(slot.mesh.normals[vertex], still, moved);
    if (slot.shown.moved.normals[vertex] == turned) continue;
    slot.shown.moved.normals[vertex] = turned;
    slot.is_bent = true;
    slot.is_sent = false;
  }
}

void PageSurface::join_ridges(Group group) {
  if (std::ranges::none_of(group, [&](const auto& place) { return slot_of(place).is_bent; }))
    return;
  float sum = 0;
  for (const RimPlace& place : group) sum += slot_of(place).shown.rim_ridges[place.index];
  const float mean = sum / static_cast<float>(group.size());
  for (const RimPlace& place : group) {
    Slot& slot = slot_of(place);
    float& ridge = slot.shown.ridges[slot.shown.rim[place.index]];
    slot.is_sent = slot.is_sent && ridge == mean;
    ridge = mean;
  }
}

Status PageSurface::send(uint32_t number) {
  Slot& slot = slots_[number];
  if (slot.is_sent) return Status::ok();
  const bool is_moved = !slot.displacements.empty();
  const std::vector<Vec3f> nowhere(is_moved ? 0 : slot.mesh.positions.size(), Vec3f::Zero());
  RETURN_IF_ERROR(renderer_.move_page(number, is_moved ? slot.displacements : nowhere,
                                      slot.shown.moved.normals, slot.shown.ridges));
  slot.is_sent = true;
  slot.is_at_rest = false;
  return Status::ok();
}

Status PageSurface::show(std::span<const PatchRange> patches) {
  take(patches);
  for (const uint32_t number : drawn_) refresh(slots_[number]);
  for (size_t group = 0; group < shared_.count(); ++group) join_normals(shared_[group]);
  for (const uint32_t number : drawn_)
    if (slots_[number].is_bent) bend_drawn_page(slots_[number].shown, slots_[number].mesh);
  for (size_t group = 0; group < shared_.count(); ++group) join_ridges(shared_[group]);
  for (const uint32_t number : drawn_) slots_[number].is_stale = slots_[number].is_bent = false;
  for (const uint32_t number : drawn_) RETURN_IF_ERROR(send(number));
  return Status::ok();
}

Status PageSurface::draw(const Camera& camera, const ImageSize& size, const DrawStyle& style,
                         std::span<const PatchRange> patches) {
  RETURN_IF_ERROR(show(patches));
  return renderer_.draw(camera, size, style, patches);
}

// Rounding of the boxes' floats must not hide a page.
static Eigen::AlignedBox3d in_file(const PageSpace& space, const Eigen::AlignedBox3f& box) {
  const Vec3f touch = Vec3f::Constant(std::numeric_limits<float>::epsilon());
  return {space.to_file(Vec3f(box.min() - touch)), space.to_file(Vec3f(box.max() + touch))};
}

std::optional<PageHit> PageSurface::hit(const Ray& ray, bool original) const {
  std::optional<PageHit> nearest;
  for (const PatchRange& patch : patches_) {
    const Slot& slot = slots_[patch.slot];
    const auto reached =
        distance_to_box(ray, in_file(space_, original ? slot.box : slot.moved_box));
    if (!reached || (nearest && *reached > nearest->point.distance)) continue;
    DisplacedPage page = at(patch.slot);
    if (original) page.displacements = {};
    const auto found = nearest_hit(page, ray, patch.first, patch.count);
    if (!found || (nearest && found->distance >= nearest->point.distance)) continue;
    nearest = PageHit{patch.slot, *found};
  }
  return nearest;
}

}  // namespace burnish
