#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include <epoxy/gl.h>

#include "client/gl/chart_order.h"
#include "client/gl/shader_program.h"
#include "client/gl/sheet_shelves.h"
#include "client/scene/page_renderer.h"
#include "client/scene/page_texture.h"
#include "common/base/status.h"

namespace burnish {

/// The textures of the pages in slots on the graphics card: the layers of one array. Needs: a
/// current context for its whole life.
class PageTextures {
 public:
  PageTextures();
  ~PageTextures();
  PageTextures(const PageTextures&) = delete;
  PageTextures& operator=(const PageTextures&) = delete;

  /// Returns how many bytes of textures have room.
  uint64_t bytes_max() const;
  /// Forgets the textures of all slots.
  void clear();
  /// Gives a slot a texture; null: none. Where the card has no room for it, the page shows its
  /// vertices' colours. `order`: chart_order() of it. Fails: resource_exhausted.
  Status put(uint32_t slot, std::shared_ptr<const PageTexture> texture, ChartOrder order);

  /// Draws patches with their textures: `draw_part` draws triangles of the order that put() was
  /// given. Needs: the program is in use; patches that begin and end where the page's do.
  void draw(const ShaderProgram& program, std::span<const PatchRange> patches,
            const std::function<void(const PatchRange&)>& draw_part) const;

 private:
  struct Slot {
    std::shared_ptr<const PageTexture> texture;
    std::vector<ChartRun> runs;
    std::optional<ShelfPlace> place;  // nothing: the card has no room
  };
  void release(Slot& slot);
  bool take_place(Slot& slot);
  void upload(const Slot& slot) const;
  Status pack_anew();
  Status make_layers() const;

  const int layers_max_;
  bool is_full_ = false;  // some slot found no place since one was given back
  GLuint array_ = 0;
  SheetShelves shelves_;
  std::vector<Slot> slots_;
};

}  // namespace burnish
