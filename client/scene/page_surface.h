#pragma once

#include <optional>
#include <span>
#include <vector>

#include "client/scene/displaced_page.h"
#include "client/scene/drawn_page.h"
#include "client/scene/page_renderer.h"
#include "client/scene/page_rims.h"
#include "client/scene/surface_hit.h"

namespace burnish {

/// A point on the page in a slot.
struct PageHit {
  uint32_t slot = 0;
  SurfaceHit point;
};

/// The pages of a session as a renderer shows them. A vertex of several drawn pages gets the normal
/// that the drawn triangles of all of them give, and the mean of their ridges, so that no border
/// shows, whatever an edit does. The original alone has each page's own ridges.
/// Used from the renderer's thread. Needs: the renderer outlives this object, and its pages are put
/// and moved by this object alone.
class PageSurface {
 public:
  explicit PageSurface(PageRenderer& renderer) : renderer_(renderer) {}

  /// Begins with another scan or another depth. All slots are empty.
  void open(const PageSpace& space);

  /// Makes room as PageRenderer::reserve() does. Fails: resource_exhausted; then nothing changes.
  Status reserve(uint32_t slots);

  /// Puts a page, not moved, in the place of what the slot held. Needs: a reserved slot.
  /// Fails: resource_exhausted; then the slot is empty.
  Status put(uint32_t slot, PageMesh mesh);

  /// Moves the page in a slot from the next show() on. Shapes: one displacement per vertex.
  /// Units: cells.
  void move(uint32_t slot, std::vector<Vec3f> displacements);

  /// Brings the renderer to what these patches show, each once, without drawing.
  /// Fails: as PageRenderer::move_page() does.
  Status show(std::span<const PatchRange> patches);

  /// Shows these patches and draws them as PageRenderer::draw() does. Fails: as it does.
  Status draw(const Camera& camera, const ImageSize& size, const DrawStyle& style,
              std::span<const PatchRange> patches);

  /// Returns the first point where the ray meets what the last show() shows. Tries the pages whose
  /// boxes the ray meets. `original`: on the surface without displacements.
  std::optional<PageHit> hit(const Ray& ray, bool original) const;

  /// Returns the page in a slot as it is moved. Needs: a reserved slot.
  DisplacedPage at(uint32_t slot) const {
    return {slots_[slot].mesh, space_, slots_[slot].displacements};
  }

 private:
  struct Slot {
    PageMesh mesh;
    std::vector<Vec3f> displacements;  // empty: not moved
    DrawnPage shown;                   // while it is drawn
    Eigen::AlignedBox3f box;           // of the positions
    Eigen::AlignedBox3f moved_box;     // of the displaced positions
    bool is_stale = false;             // moved or drawn in another way since the last draw()
    bool is_bent = false;              // its normals changed since the last draw()
    bool is_at_rest = true;            // the renderer has the page as it was put
    bool is_sent = true;               // the renderer has what is shown
  };
  using Group = std::span<const RimPlace>;
  Slot& slot_of(const RimPlace& place) { return slots_[drawn_[place.page]]; }
  void take(std::span<const PatchRange> patches);
  void begin(uint32_t slot, std::span<const PatchRange> patches);
  void forget_undrawn(const std::vector<uint32_t>& drawn);
  void find_rims();
  void refresh(Slot& slot) const;
  void join_normals(Group group);
  void join_ridges(Group group);
  Status send(uint32_t slot);

  PageRenderer& renderer_;
  PageSpace space_;
  std::vector<Slot> slots_;
  std::vector<PatchRange> patches_;  // of the last draw(), by slot
  bool has_new_pages_ = false;       // since the last draw()
  std::vector<uint32_t> drawn_;      // slots, rising
  Groups<RimPlace> shared_;          // their rims; pages are numbered as in drawn_
};

}  // namespace burnish
