#pragma once

#include <memory>

#include "client/gl/mesh_buffers.h"
#include "client/gl/mesh_uniforms.h"
#include "client/gl/pick_target.h"
#include "client/gl/picture_target.h"
#include "client/gl/shader_program.h"
#include "client/gl/surface_buffers.h"
#include "client/scene/renderer.h"

namespace burnish {

/// Draws with the OpenGL context that is current on the calling thread. Needs: the context outlives
/// this object.
class GlRenderer : public Renderer {
 public:
  /// Fails: internal_error when the driver refuses a shader.
  static Result<std::unique_ptr<GlRenderer>> create();

  Status upload_mesh(const ViewMesh& mesh) override;
  Status upload_displacements(std::span<const Vec3f> displacements,
                              std::span<const IndexRange> changed) override {
    return surface_.upload_displacements(displacements, changed);
  }
  Status upload_cell_values(std::span<const float> values) override {
    return surface_.upload_cell_values(values);
  }
  Status upload_cell_tint(std::span<const float> weights, IndexRange changed) override {
    return surface_.upload_cell_tint(weights, changed);
  }
  Status draw(const Camera& camera, const ImageSize& size, const DrawStyle& style) override;
  Result<Image> read_pixels() override { return target_.read(); }
  Result<std::optional<uint32_t>> pick(const Camera& camera, const ImageSize& size,
                                       const Eigen::Vector2i& pixel, bool original) override;

  /// Copies the last drawn picture into the window's own buffer, with its lower left corner at this
  /// place.
  void show(const Eigen::Vector2i& lower_left) const { target_.show(lower_left); }
  /// Clears the window's own buffer to dark and makes it the drawing target.
  void clear_window() const;

 private:
  struct Programs {
    ShaderProgram mesh;
    ShaderProgram pick;
    ShaderProgram background;
  };
  explicit GlRenderer(Programs programs) : programs_(std::move(programs)) {}
  void draw_background() const;
  void draw_split(const Camera& camera, const ImageSize& size, const DrawStyle& style) const;
  void draw_mesh(const Camera& camera, double aspect, const DrawStyle& style, bool original) const;
  void draw_edges() const;

  Programs programs_;
  MeshBuffers mesh_;
  MeshBuffers no_mesh_;  // a core profile needs a vertex array to draw
  SurfaceBuffers surface_;
  PictureTarget target_;
  PickTarget pick_target_;
  MeshPlace place_;
};

}  // namespace burnish
