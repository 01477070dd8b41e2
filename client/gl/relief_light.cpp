#include "client/gl/relief_light.h"

#include "client/gl/shaders.h"

namespace burnish {

Result<std::unique_ptr<ReliefLight>> ReliefLight::create() {
  ASSIGN_OR_RETURN(
      ShaderProgram occlusion,
      ShaderProgram::create("occlusion", kBackgroundVertexShader, occlusion_shader().c_str()));
  ASSIGN_OR_RETURN(ShaderProgram relief, ShaderProgram::create("relief", kBackgroundVertexShader,
                                                               relief_shader().c_str()));
  return std::unique_ptr<ReliefLight>(new ReliefLight(std::move(occlusion), std::move(relief)));
}

ReliefLight::ReliefLight(ShaderProgram occlusion, ShaderProgram relief)
    : occlusion_(std::move(occlusion)), relief_(std::move(relief)) {
  glGenVertexArrays(1, &vertex_array_);
}

ReliefLight::~ReliefLight() {
  glDeleteVertexArrays(1, &vertex_array_);
}

static void set_places(const ShaderProgram& program, const ReliefTarget& target,
                       const Camera& camera) {
  const ImageSize& size = target.size();
  const Eigen::Matrix4f projection = projection_matrix(camera, size.aspect()).cast<float>();
  program.use();
  program.set("colours", 0);
  program.set("reliefs", 1);
  program.set("depths", 2);
  program.set("size", Eigen::Vector2i(size.width, size.height));
  program.set("parallel", camera.orthographic);
  program.set("half_view", Eigen::Vector2f(1 / projection(0, 0), 1 / projection(1, 1)));
  program.set("depth_terms", Eigen::Vector4f(projection(2, 2), projection(2, 3), projection(3, 2),
                                             projection(3, 3)));
}

void ReliefLight::fill() const {
  glDisable(GL_DEPTH_TEST);
  glBindVertexArray(vertex_array_);
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

void ReliefLight::occlude(const ReliefTarget& target, const Camera& camera) const {
  set_places(occlusion_, target, camera);
  target.bind_for_occlusion();
  target.bind_textures();
  glActiveTexture(GL_TEXTURE3);
  glBindTexture(GL_TEXTURE_2D, 0);  // it is drawn into
  fill();
}

void ReliefLight::draw(const ReliefTarget& target, const Camera& camera,
                       const Lighting& lighting) const {
  set_places(relief_, target, camera);
  target.bind_textures();
  relief_.set("occlusions", 3);
  relief_.set("samples", target.samples());
  relief_.set("light_kind", static_cast<int>(lighting.kind));
  relief_.set("radiance", static_cast<float>(lighting.radiance));
  relief_.set("ridge", static_cast<float>(lighting.ridge));
  relief_.set("valley", static_cast<float>(lighting.valley));
  relief_.set("occlusion", static_cast<float>(lighting.occlusion));
  fill();
}

}  // namespace burnish
