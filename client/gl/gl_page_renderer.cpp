#include "client/gl/gl_page_renderer.h"

#include "client/gl/gl_error.h"
#include "client/gl/page_uniforms.h"
#include "client/gl/shaders.h"

namespace burnish {

Result<std::unique_ptr<GlPageRenderer>> GlPageRenderer::create() {
  ASSIGN_OR_RETURN(ShaderProgram page, ShaderProgram::create("page", kPageVertexShader,
                                                             page_fragment_shader().c_str()));
  ASSIGN_OR_RETURN(auto background, Background::create());
  ASSIGN_OR_RETURN(auto g_buffer, GBufferLight::create());
  Programs programs{std::move(page), {}, std::move(background), std::move(g_buffer)};
  return std::unique_ptr<GlPageRenderer>(new GlPageRenderer(std::move(programs)));
}

void GlPageRenderer::open(const PageSpace& space) {
  space_ = space;
  arena_.clear();
  textures_.clear();
}

// The slot's texture goes with the page.
Status GlPageRenderer::upload_page(uint32_t slot, const PageMesh& mesh) {
  RETURN_IF_ERROR(textures_.put(slot, nullptr, {}));
  return arena_.upload_page(slot, mesh);
}

static Result<ShaderProgram> textured_program() {
  const std::string define = "#define TEXTURES\n";
  return ShaderProgram::create("textured page", (define + kPageVertexShader).c_str(),
                               (define + page_fragment_shader()).c_str());
}

Status GlPageRenderer::texture_page(uint32_t slot, std::shared_ptr<const PageTexture> texture) {
  if (texture == nullptr) return textures_.put(slot, nullptr, {});
  if (!programs_.textured) {
    ASSIGN_OR_RETURN(ShaderProgram textured, textured_program());
    programs_.textured.emplace(std::move(textured));
  }
  ChartOrder order = chart_order(*texture);
  RETURN_IF_ERROR(arena_.order_page(slot, order.triangles));
  return textures_.put(slot, std::move(texture), std::move(order));
}

Status GlPageRenderer::draw(const Camera& camera, const ImageSize& size, const DrawStyle& style,
                            std::span<const PatchRange> patches) {
  arena_.choose(patches);
  if (style.wireframe) RETURN_IF_ERROR(arena_.choose_edges());
  RETURN_IF_ERROR(target_.bind(size));
  if (!patches.empty() && needs_surroundings(style.lighting))
    return draw_g_buffer(camera, size, style);
  programs_.background->draw();
  if (!patches.empty()) draw_split(camera, size, style);
  target_.resolve();
  return check_gl("drawing");
}

Status GlPageRenderer::draw_g_buffer(const Camera& camera, const ImageSize& size,
                                     const DrawStyle& style) {
  RETURN_IF_ERROR(g_buffer_target_.bind_for_background(size));
  programs_.background->draw();
  g_buffer_target_.bind_for_surfaces();
  draw_split(camera, size, style);
  const Camera scaled = in_units(space_, camera);
  g_buffer_target_.resolve();
  if (style.lighting.occlusion > 0) programs_.g_buffer->occlude(g_buffer_target_, scaled);
  target_.bind_resolved();
  programs_.g_buffer->draw(g_buffer_target_, scaled, style.lighting);
  return check_gl("drawing");
}

void GlPageRenderer::draw_split(const Camera& camera, const ImageSize& size,
                                const DrawStyle& style) const {
  glEnable(GL_DEPTH_TEST);
  glClear(GL_DEPTH_BUFFER_BIT);
  const int middle = split_column(style.split, size.width);
  glEnable(GL_SCISSOR_TEST);
  glScissor(middle, 0, size.width - middle, size.height);
  draw_pages(camera, size.aspect(), style, style.original);
  if (middle > 0) {
    glScissor(0, 0, middle, size.height);
    draw_pages(camera, size.aspect(), style, true);
  }
  glDisable(GL_SCISSOR_TEST);
}

void GlPageRenderer::draw_pages(const Camera& camera, double aspect, const DrawStyle& style,
                                bool original) const {
  const bool is_textured = style.colouring == Colouring::kScan && programs_.textured;
  const ShaderProgram& program = is_textured ? *programs_.textured : programs_.page;
  program.use();
  set_place(program, space_, camera, aspect, original);
  set_style(program, space_, style);
  // Leaves room for the edges in front. Without edges a triangle that is seen from its side would
  // fall behind what it hides.
  if (style.wireframe) glEnable(GL_POLYGON_OFFSET_FILL);
  glPolygonOffset(1, 1);
  if (is_textured) {
    textures_.draw(program, arena_.chosen(),
                   [this](const PatchRange& part) { arena_.draw_part(part); });
  } else {
    arena_.draw();
  }
  glDisable(GL_POLYGON_OFFSET_FILL);
  if (style.wireframe) draw_edges(program);
}

void GlPageRenderer::draw_edges(const ShaderProgram& program) const {
  program.set("edges", true);
  glEnable(GL_BLEND);  // by the alpha of each output: that of the geometry is 0, so it stays
  glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
  arena_.draw_edges();
  glDisable(GL_BLEND);
}

}  // namespace burnish
