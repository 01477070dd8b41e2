#include "client/gl/gl_renderer.h"

#include "client/gl/gl_error.h"
#include "client/gl/shaders.h"

namespace burnish {

Result<std::unique_ptr<GlRenderer>> GlRenderer::create() {
  ASSIGN_OR_RETURN(ShaderProgram mesh,
                   ShaderProgram::create("mesh", kMeshVertexShader, kMeshFragmentShader));
  ASSIGN_OR_RETURN(ShaderProgram pick,
                   ShaderProgram::create("pick", kMeshVertexShader, kPickFragmentShader));
  ASSIGN_OR_RETURN(
      ShaderProgram background,
      ShaderProgram::create("background", kBackgroundVertexShader, kBackgroundFragmentShader));
  Programs programs{std::move(mesh), std::move(pick), std::move(background)};
  return std::unique_ptr<GlRenderer>(new GlRenderer(std::move(programs)));
}

Status GlRenderer::upload_mesh(const ViewMesh& mesh) {
  place_ = {mesh.box.center(), mesh.unit(), mesh.cell_size, mesh.has_grid()};
  RETURN_IF_ERROR(mesh_.upload(mesh));
  const Status grid = surface_.upload(mesh);
  if (!grid.is_ok()) mesh_.clear();
  return grid;
}

Status GlRenderer::draw(const Camera& camera, const ImageSize& size, const DrawStyle& style) {
  RETURN_IF_ERROR(target_.bind(size));
  draw_background();
  if (!mesh_.is_empty()) draw_split(camera, size, style);
  target_.resolve();
  return check_gl("drawing");
}

void GlRenderer::clear_window() const {
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  glClearColor(0.145f, 0.155f, 0.170f, 1);
  glClear(GL_COLOR_BUFFER_BIT);
}

void GlRenderer::draw_background() const {
  glDisable(GL_DEPTH_TEST);
  programs_.background.use();
  no_mesh_.bind();
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

void GlRenderer::draw_split(const Camera& camera, const ImageSize& size,
                            const DrawStyle& style) const {
  glEnable(GL_DEPTH_TEST);
  glClear(GL_DEPTH_BUFFER_BIT);
  const int middle = split_column(style.split, size.width);
  glEnable(GL_SCISSOR_TEST);
  glScissor(middle, 0, size.width - middle, size.height);
  draw_mesh(camera, size.aspect(), style, style.original);
  if (middle > 0) {
    glScissor(0, 0, middle, size.height);
    draw_mesh(camera, size.aspect(), style, true);
  }
  glDisable(GL_SCISSOR_TEST);
}

void GlRenderer::draw_mesh(const Camera& camera, double aspect, const DrawStyle& style,
                           bool original) const {
  programs_.mesh.use();
  surface_.bind();
  set_place(programs_.mesh, place_, camera, aspect, original);
  set_style(programs_.mesh, place_, style);
  glEnable(GL_POLYGON_OFFSET_FILL);  // leaves room for the edges in front
  glPolygonOffset(1, 1);
  mesh_.draw();
  glDisable(GL_POLYGON_OFFSET_FILL);
  if (style.wireframe) draw_edges();
}

void GlRenderer::draw_edges() const {
  programs_.mesh.set("edges", true);
  glEnable(GL_BLEND);
  glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
  mesh_.draw();
  glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
  glDisable(GL_BLEND);
}

Result<std::optional<uint32_t>> GlRenderer::pick(const Camera& camera, const ImageSize& size,
                                                 const Eigen::Vector2i& pixel, bool original) {
  if (mesh_.is_empty()) return std::optional<uint32_t>();
  RETURN_IF_ERROR(pick_target_.bind());
  programs_.pick.use();
  surface_.bind();
  set_place(programs_.pick, place_, camera, size.aspect(), original, pick_matrix(size, pixel));
  glEnable(GL_DEPTH_TEST);
  mesh_.draw();
  const std::optional<uint32_t> triangle = pick_target_.read();
  RETURN_IF_ERROR(check_gl("picking"));
  return triangle;
}

}  // namespace burnish
