#include "client/gl/gl_page_renderer.h"

#include "client/gl/gl_error.h"
#include "client/gl/page_uniforms.h"
#include "client/gl/shaders.h"

namespace burnish {

static constexpr uint32_t kNumbersPerSlot = kPageTrianglesMax;
static_assert(uint64_t{kPageSlotsMax} * kNumbersPerSlot < uint64_t{1} << 31, "a number is an int");

Result<std::unique_ptr<GlPageRenderer>> GlPageRenderer::create() {
  ASSIGN_OR_RETURN(ShaderProgram page,
                   ShaderProgram::create("page", kPageVertexShader, kPageFragmentShader));
  ASSIGN_OR_RETURN(ShaderProgram pick,
                   ShaderProgram::create("page pick", kPageVertexShader, kPickFragmentShader));
  ASSIGN_OR_RETURN(auto background, Background::create());
  Programs programs{std::move(page), std::move(pick), std::move(background)};
  return std::unique_ptr<GlPageRenderer>(new GlPageRenderer(std::move(programs)));
}

void GlPageRenderer::open(const PageSpace& space) {
  space_ = space;
  arena_.clear();
}

Status GlPageRenderer::draw(const Camera& camera, const ImageSize& size, const DrawStyle& style,
                            std::span<const PatchRange> patches) {
  arena_.choose(patches);
  RETURN_IF_ERROR(target_.bind(size));
  programs_.background->draw();
  if (!patches.empty()) draw_split(camera, size, style);
  target_.resolve();
  return check_gl("drawing");
}

void GlPageRenderer::clear_window() const {
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  glClearColor(0.145f, 0.155f, 0.170f, 1);
  glClear(GL_COLOR_BUFFER_BIT);
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
  programs_.page.use();
  set_place(programs_.page, space_, camera, aspect, original);
  set_style(programs_.page, space_, style);
  // Leaves room for the edges in front. Without edges a triangle that is seen from its side would
  // fall behind what it hides.
  if (style.wireframe) glEnable(GL_POLYGON_OFFSET_FILL);
  glPolygonOffset(1, 1);
  arena_.draw();
  glDisable(GL_POLYGON_OFFSET_FILL);
  if (style.wireframe) draw_edges();
}

void GlPageRenderer::draw_edges() const {
  programs_.page.set("edges", true);
  glEnable(GL_BLEND);
  glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
  arena_.draw();
  glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
  glDisable(GL_BLEND);
}

// Patch by patch: OpenGL 3.3 does not tell a shader which of several draws it works for.
Result<std::optional<PagePick>> GlPageRenderer::pick(const Camera& camera, const ImageSize& size,
                                                     const Eigen::Vector2i& pixel, bool original,
                                                     std::span<const PatchRange> patches) {
  RETURN_IF_ERROR(pick_target_.bind());
  programs_.pick.use();
  set_place(programs_.pick, space_, camera, size.aspect(), original, pick_matrix(size, pixel));
  glEnable(GL_DEPTH_TEST);
  for (const PatchRange& patch : patches) {
    programs_.pick.set("first_number",
                       static_cast<int>(patch.slot * kNumbersPerSlot + patch.first));
    arena_.draw(patch);
  }
  const std::optional<uint32_t> number = pick_target_.read();
  RETURN_IF_ERROR(check_gl("picking"));
  if (!number) return std::optional<PagePick>();
  return std::optional(PagePick{*number / kNumbersPerSlot, *number % kNumbersPerSlot});
}

}  // namespace burnish
