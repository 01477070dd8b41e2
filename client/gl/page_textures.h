#pragma once

#include <cstdint>
#include <memory>

#include "client/gl/shader_program.h"
#include "client/scene/page_renderer.h"
#include "client/scene/page_texture.h"
#include "common/base/status.h"

namespace burnish {

/// The textures of the pages in slots on the graphics card. Needs: a current context for its whole
/// life.
class PageTextures {
 public:
  PageTextures() = default;
  virtual ~PageTextures() = default;
  PageTextures(const PageTextures&) = delete;
  PageTextures& operator=(const PageTextures&) = delete;

  /// Returns what draws pages with their textures. Fails: as ShaderProgram::create().
  virtual Result<ShaderProgram> make_program() const = 0;

  /// Returns how many bytes of textures have room.
  virtual uint64_t bytes_max() const = 0;
  /// Forgets the textures of all slots.
  virtual void clear() = 0;
  /// Gives a slot a texture; null: none. Where the card has no room for it, the page shows its
  /// vertices' colours. Fails: resource_exhausted.
  virtual Status put(uint32_t slot, std::shared_ptr<const PageTexture> texture) = 0;

  /// Makes the textures ready for a program in use.
  virtual void bind(const ShaderProgram& program) const = 0;
  /// Says to a program in use where a patch's texture lies.
  virtual void choose(const ShaderProgram& program, const PatchRange& patch) const = 0;
};

/// Returns null where the current context has no buffer textures: OpenGL ES, as in browsers.
std::unique_ptr<PageTextures> make_page_textures();

}  // namespace burnish
