#pragma once

#include <memory>
#include <optional>

#include "client/gl/background.h"
#include "client/gl/g_buffer_light.h"
#include "client/gl/g_buffer_target.h"
#include "client/gl/page_arena.h"
#include "client/gl/page_textures.h"
#include "client/gl/picture_target.h"
#include "client/gl/shader_program.h"
#include "client/scene/page_renderer.h"

namespace burnish {

/// Draws pages with the OpenGL context that is current on the calling thread. Needs: the context
/// outlives this object.
class GlPageRenderer : public PageRenderer {
 public:
  /// Fails: internal_error when the driver refuses a shader.
  static Result<std::unique_ptr<GlPageRenderer>> create();

  void open(const PageSpace& space) override;
  Status reserve(uint32_t slots) override { return arena_.reserve(slots); }
  Status upload_page(uint32_t slot, const PageMesh& mesh) override;
  Status move_page(uint32_t slot, std::span<const Vec3f> displacements,
                   std::span<const Vec3f> normals, std::span<const float> ridges) override {
    return arena_.move_page(slot, displacements, normals, ridges);
  }
  Status mark_page(uint32_t slot, std::span<const VertexMark> marks) override {
    return arena_.mark_page(slot, marks);
  }
  Status colour_page(uint32_t slot, std::span<const Rgba8> colours,
                     std::span<const TexelChange> texels) override {
    return arena_.colour_page(slot, colours, texels);
  }
  uint64_t texture_bytes_max() const override { return textures_.bytes_max(); }
  Status texture_page(uint32_t slot, std::shared_ptr<const PageTexture> texture) override;
  Status draw(const Camera& camera, const ImageSize& size, const DrawStyle& style,
              std::span<const PatchRange> patches) override;
  Result<Image> read_pixels() override { return target_.read(); }

  /// Copies the last drawn picture into the window's own buffer, with its lower left corner at this
  /// place.
  void show(const Eigen::Vector2i& lower_left) const { target_.show(lower_left); }

 private:
  struct Programs {
    ShaderProgram page;
    std::optional<ShaderProgram> textured;  // made for the first texture
    std::unique_ptr<Background> background;
    std::unique_ptr<GBufferLight> g_buffer;
  };
  explicit GlPageRenderer(Programs programs) : programs_(std::move(programs)) {}
  Status draw_g_buffer(const Camera& camera, const ImageSize& size, const DrawStyle& style);
  void draw_split(const Camera& camera, const ImageSize& size, const DrawStyle& style) const;
  void draw_pages(const Camera& camera, double aspect, const DrawStyle& style, bool original) const;
  void draw_edges(const ShaderProgram& program) const;

  Programs programs_;
  PageTextures textures_;
  PageArena arena_;
  PictureTarget target_;
  GBufferTarget g_buffer_target_;
  PageSpace space_;
};

}  // namespace burnish
