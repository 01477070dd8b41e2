#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "client/scene/camera.h"
#include "client/scene/draw_style.h"
#include "client/scene/image.h"
#include "client/scene/page_mesh.h"
#include "client/scene/page_space.h"
#include "client/scene/page_texture.h"
#include "common/base/status.h"
#include "common/mesh/textures/texel_change.h"

namespace burnish {

/// Triangles first..first+count of the page in a slot.
struct PatchRange {
  uint32_t slot = 0;
  uint32_t first = 0;
  uint32_t count = 0;

  bool operator==(const PatchRange&) const = default;
};

/// Colours of a vertex besides its light.
struct VertexMark {
  int8_t value = 0;      ///< what Colouring::kCells shows: -127 is blue, 127 is red
  uint8_t tint = 0;      ///< how strongly it shows DrawStyle::tint: 255 is fully
  uint16_t overlay = 0;  ///< packed_overlay()
};

/// A thin colour over the surface. `colour` is 0xRRGGBB, of which 4 bits each are kept; nothing: no
/// colour. `is_hatched`: stripes of protection, which no tint covers.
inline uint16_t packed_overlay(std::optional<uint32_t> colour, bool is_hatched) {
  const uint32_t rgb = colour.value_or(0);
  const uint32_t kept = (rgb >> 12 & 0xf00) | (rgb >> 8 & 0xf0) | (rgb >> 4 & 0xf);
  return static_cast<uint16_t>(kept << 4 | (is_hatched ? 2U : 0U) | (colour ? 1U : 0U));
}

/// Fails: resource_exhausted above kPageSlotsMax.
inline Status check_page_slots(uint32_t slots) {
  if (slots <= kPageSlotsMax) return Status::ok();
  return resource_exhausted("room for " + std::to_string(slots) + " pages: the limit is " +
                            std::to_string(kPageSlotsMax));
}

/// Draws pages: with OpenGL (client/gl), or without pictures (NullPageRenderer). A slot holds one
/// page. Used from one thread.
class PageRenderer {
 public:
  virtual ~PageRenderer() = default;

  /// Begins with another scan or another depth. All slots are empty.
  virtual void open(const PageSpace& space) = 0;

  /// Makes room for slots 0..slots and keeps what they hold. Never takes room away.
  /// Fails: resource_exhausted; then nothing changes.
  virtual Status reserve(uint32_t slots) = 0;

  /// Puts a page in the place of what the slot held: not moved, without marks. Needs: a reserved
  /// slot and a page within the limits. Fails: resource_exhausted; then the slot is empty.
  virtual Status upload_page(uint32_t slot, const PageMesh& mesh) = 0;

  /// Moves the page in a slot. PageSurface makes the normals, unit length, and the ridges of
  /// vertex_ridges(). Shapes: one per vertex of the page. Units: displacements in cells.
  virtual Status move_page(uint32_t slot, std::span<const Vec3f> displacements,
                           std::span<const Vec3f> normals, std::span<const float> ridges) = 0;

  /// Shapes: one per vertex of the page in the slot.
  virtual Status mark_page(uint32_t slot, std::span<const VertexMark> marks) = 0;

  /// Gives the displaced surface of a page other colours than its original has, and its texels the
  /// change that goes with them. Shapes: one per vertex of the page in the slot.
  virtual Status colour_page(uint32_t slot, std::span<const Rgba8> colours,
                             std::span<const TexelChange> texels) = 0;

  /// Returns how many bytes of textures have room; 0: texture_page() has no effect.
  virtual uint64_t texture_bytes_max() const { return 0; }

  /// Gives a page a texture, which pictures show in place of its vertices' colours; null takes it
  /// away. Texels of the displaced surface change as colour_page() says.
  /// Needs: the page in the slot has one triangle per chart number, and the texture's patches are
  /// those that draw() draws, alone or several in a row. Fails: resource_exhausted; then
  /// the page has no texture.
  virtual Status texture_page(uint32_t /*slot*/, std::shared_ptr<const PageTexture> /*texture*/) {
    return Status::ok();
  }

  /// Draws these patches in front of the background. Needs: ranges inside the pages of their slots.
  /// Fails: invalid_argument (size), resource_exhausted.
  virtual Status draw(const Camera& camera, const ImageSize& size, const DrawStyle& style,
                      std::span<const PatchRange> patches) = 0;

  /// Returns the last drawn picture. Fails: failed_precondition before the first draw().
  virtual Result<Image> read_pixels() = 0;
};

}  // namespace burnish
