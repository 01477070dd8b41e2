#include "client/gl/g_buffer_light.h"

#include "client/gl/shaders.h"

namespace burnish {

Result<std::unique_ptr<GBufferLight>> GBufferLight::create() {
  ASSIGN_OR_RETURN(
      ShaderProgram occlusion,
      ShaderProgram::create("occlusion", kBackgroundVertexShader, occlusion_shader().c_str()));
  ASSIGN_OR_RETURN(
      ShaderProgram g_buffer,
      ShaderProgram::create("g_buffer", kBackgroundVertexShader, g_buffer_shader().c_str()));
  return std::unique_ptr<GBufferLight>(new GBufferLight(std::move(occlusion), std::move(g_buffer)));
}

GBufferLight::GBufferLight(ShaderProgram occlusion, ShaderProgram g_buffer)
    : occlusion_(std::move(occlusion)), g_buffer_(std::move(g_buffer)) {
  glGenVertexArrays(1, &vertex_array_);
}

GBufferLight::~GBufferLight() {
  glDeleteVertexArrays(1, &vertex_array_);
}

static void set_places(const ShaderProgram& program, const GBufferTarget& target,
                       const Camera& camera) {
  const ImageSize& size = target.size();
  const Eigen::Matrix4f projection = projection_matrix(camera, size.aspect()).cast<float>();
  program.use();
  program.set("colours", 0);
  program.set("geometries", 1);
  program.set("depths", 2);
  program.set("size", Eigen::Vector2i(size.width, size.height));
  program.set("parallel", camera.orthographic);
  program.set("half_view", Eigen::Vector2f(1 / projection(0, 0), 1 / projection(1, 1)));
  program.set("depth_terms", Eigen::Vector4f(projection(2, 2), projection(2, 3), projection(3, 2),
                                             projection(3, 3)));
}

void GBufferLight::fill() const {
  glDisable(GL_DEPTH_TEST);
  glBindVertexArray(vertex_array_);
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

void GBufferLight::occlude(const GBufferTarget& target, const Camera& camera) const {
  set_places(occlusion_, target, camera);
  target.bind_for_occlusion();
  target.bind_textures();
  glActiveTexture(GL_TEXTURE3);
  glBindTexture(GL_TEXTURE_2D, 0);  // it is drawn into
  fill();
}

void GBufferLight::draw(const GBufferTarget& target, const Camera& camera,
                        const Lighting& lighting) const {
  set_places(g_buffer_, target, camera);
  target.bind_textures();
  g_buffer_.set("occlusions", 3);
  g_buffer_.set("samples", target.samples());
  g_buffer_.set("light_kind", static_cast<int>(lighting.kind));
  g_buffer_.set("radiance", static_cast<float>(lighting.radiance));
  g_buffer_.set("ridge", static_cast<float>(lighting.ridge));
  g_buffer_.set("valley", static_cast<float>(lighting.valley));
  g_buffer_.set("occlusion", static_cast<float>(lighting.occlusion));
  fill();
}

}  // namespace burnish
