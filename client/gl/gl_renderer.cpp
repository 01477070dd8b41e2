#include "client/gl/gl_renderer.h"

#include "client/gl/gl_error.h"
#include "client/gl/shaders.h"

namespace burnish {

Result<std::unique_ptr<GlRenderer>> GlRenderer::create() {
  ASSIGN_OR_RETURN(ShaderProgram mesh,
                   ShaderProgram::create("mesh", kMeshVertexShader, kMeshFragmentShader));
  ASSIGN_OR_RETURN(
      ShaderProgram background,
      ShaderProgram::create("background", kBackgroundVertexShader, kBackgroundFragmentShader));
  return std::unique_ptr<GlRenderer>(new GlRenderer(std::move(mesh), std::move(background)));
}

GlRenderer::GlRenderer(ShaderProgram mesh_program, ShaderProgram background_program)
    : mesh_program_(std::move(mesh_program)), background_program_(std::move(background_program)) {}

Status GlRenderer::upload_mesh(const ViewMesh& mesh) {
  mesh_centre_ = mesh.box.center();
  mesh_unit_ = mesh.unit();
  return mesh_.upload(mesh);
}

Status GlRenderer::draw(const Camera& camera, const ImageSize& size, const DrawStyle& style) {
  RETURN_IF_ERROR(target_.bind(size));
  draw_background();
  if (!mesh_.is_empty()) draw_mesh(camera, size.aspect(), style);
  target_.resolve();
  return check_gl("drawing");
}

void GlRenderer::draw_background() const {
  glDisable(GL_DEPTH_TEST);
  background_program_.use();
  no_mesh_.bind();
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

// Camera space in units of the mesh's half diagonal, so that floats suffice at any file unit.
Eigen::Matrix4d GlRenderer::model_view(const Camera& camera) const {
  Eigen::Matrix4d centre = Eigen::Matrix4d::Identity();
  centre.topRightCorner<3, 1>() = mesh_centre_;
  Eigen::Matrix4d seen = view_matrix(camera) * centre;
  seen.topRightCorner<3, 1>() /= mesh_unit_;
  return seen;
}

void GlRenderer::draw_mesh(const Camera& camera, double aspect, const DrawStyle& style) const {
  Camera scaled = camera;
  scaled.distance /= mesh_unit_;
  scaled.scene_radius /= mesh_unit_;
  mesh_program_.use();
  mesh_program_.set("model_view", Eigen::Matrix4f(model_view(camera).cast<float>()));
  mesh_program_.set("projection", Eigen::Matrix4f(projection_matrix(scaled, aspect).cast<float>()));
  mesh_program_.set("flat_normals", style.flat);
  mesh_program_.set("edges", false);
  glEnable(GL_DEPTH_TEST);
  glClear(GL_DEPTH_BUFFER_BIT);
  glEnable(GL_POLYGON_OFFSET_FILL);  // leaves room for the edges in front
  glPolygonOffset(1, 1);
  mesh_.draw();
  glDisable(GL_POLYGON_OFFSET_FILL);
  if (!style.wireframe) return;
  mesh_program_.set("edges", true);
  glEnable(GL_BLEND);
  glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
  mesh_.draw();
  glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
  glDisable(GL_BLEND);
}

}  // namespace burnish
