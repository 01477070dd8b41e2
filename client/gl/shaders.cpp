#include "client/gl/shaders.h"

namespace burnish {

std::string page_fragment_shader() {
  return std::string(kPageLights) + kPagePixels;
}

std::string occlusion_shader() {
  return std::string(kReliefParts) + kOcclusionPixels;
}

std::string relief_shader() {
  return std::string(kReliefParts) + kReliefPixels;
}

const char* const kBackgroundVertexShader = R"(
out float height;
void main() {
  vec2 corner = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
  height = 0.5 + 0.5 * corner.y;
  gl_Position = vec4(corner, 0.0, 1.0);
}
)";

const char* const kBackgroundFragmentShader = R"(
in float height;
out vec4 colour;
void main() {
  colour = vec4(mix(vec3(0.70, 0.72, 0.75), vec3(0.93, 0.94, 0.95), height), 1.0);
}
)";

}  // namespace burnish
