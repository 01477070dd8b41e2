#include "client/gl/shaders.h"

#include "client/gl/glsl.h"
#include "client/scene/shade_constants.h"

namespace burnish {

std::string shade_constants() {
#define BURNISH_GLSL_VECTOR(name, x, y, z) "const vec3 " #name " = vec3(" #x ", " #y ", " #z ");\n"
#define BURNISH_GLSL_NUMBER(name, value) "const float " #name " = " #value ";\n"
  return BURNISH_SHADE_VECTORS(BURNISH_GLSL_VECTOR) BURNISH_SHADE_NUMBERS(BURNISH_GLSL_NUMBER);
#undef BURNISH_GLSL_VECTOR
#undef BURNISH_GLSL_NUMBER
}

std::string background_fragment_shader() {
  return shade_constants() + kBackgroundFragmentPixels;
}

std::string page_fragment_shader() {
  return shade_constants() + kPageLights + kPagePixels + kPageTexels;
}

std::string occlusion_shader() {
  return std::string(kGBufferParts) + kOcclusionPixels;
}

std::string g_buffer_shader() {
  return shade_constants() + kGBufferParts + kGBufferPixels;
}

const char* const kBackgroundVertexShader = R"(
out float height;
void main() {
  vec2 corner = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
  height = 0.5 + 0.5 * corner.y;
  gl_Position = vec4(corner, 0.0, 1.0);
}
)"_glsl;

const char* const kBackgroundFragmentPixels = R"(
in float height;
out vec4 colour;
void main() {
  colour = vec4(mix(kBackgroundLow, kBackgroundHigh, height), 1.0);
}
)"_glsl;

}  // namespace burnish
