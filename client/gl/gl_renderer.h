#pragma once

#include <memory>

#include "client/gl/mesh_buffers.h"
#include "client/gl/picture_target.h"
#include "client/gl/shader_program.h"
#include "client/renderer.h"

namespace burnish {

/// Draws with the OpenGL context that is current on the calling thread, which must outlive it.
class GlRenderer : public Renderer {
 public:
  /// Fails: internal_error when the driver refuses a shader.
  static Result<std::unique_ptr<GlRenderer>> create();

  Status upload_mesh(const ViewMesh& mesh) override;
  Status draw(const Camera& camera, const ImageSize& size, const DrawStyle& style) override;
  Result<Image> read_pixels() override { return target_.read(); }

 private:
  GlRenderer(ShaderProgram mesh_program, ShaderProgram background_program);
  void draw_background() const;
  void draw_mesh(const Camera& camera, double aspect, const DrawStyle& style) const;
  Eigen::Matrix4d model_view(const Camera& camera) const;

  ShaderProgram mesh_program_;
  ShaderProgram background_program_;
  MeshBuffers mesh_;
  MeshBuffers no_mesh_;  // core profiles draw nothing without a vertex array
  PictureTarget target_;
  Vec3d mesh_centre_ = Vec3d::Zero();  // file units
  double mesh_unit_ = 1;
};

}  // namespace burnish
