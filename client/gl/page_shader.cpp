#include "client/gl/glsl.h"
#include "client/gl/shaders.h"

namespace burnish {

// A page's vertices come with displacements and with normals of both surfaces. Products with
// cell_size, a power of two, are exact. So vertices that pages share end at the same place.
const char* const kPageVertexShader = R"(
layout(location = 0) in vec3 position;
layout(location = 1) in int shade;
layout(location = 2) in vec4 colour;
layout(location = 3) in vec3 displacement;  // cells
layout(location = 4) in int displaced_shade;
layout(location = 5) in float marked_value;  // -127 to 127
layout(location = 6) in float marked_tint;   // 0 to 1
layout(location = 8) in vec4 displaced_colour;
layout(location = 9) in vec4 displaced_texel;  // TexelVertex
layout(location = 7) in int marked_overlay;  // packed_overlay(), the highest bit as a sign
uniform mat4 model_view;
uniform mat4 projection;
uniform float cell_size;  // 0: nothing moves
centroid out vec3 seen_position;  // camera space
centroid out vec3 seen_normal;
centroid out float seen_ridge;
out vec3 original_position;
centroid out float value;
centroid out float tint;
centroid out vec4 overlay;   // sRGB times the fourth
centroid out float hatched;  // 0 to 1
centroid out float moved;  // along the normal, cells
centroid out vec3 scan_colour;
#ifdef TEXTURES
centroid out vec4 texel_change;
centroid out vec3 texel_position;
#endif

// Unpack packed_shade(). Shifts to the right keep the sign.
vec3 normal_of(int shade) {
  vec2 square = vec2(shade << 20 >> 20, shade << 8 >> 20) / 2047.0;
  float height = 1.0 - abs(square.x) - abs(square.y);
  vec2 unfolded = mix(vec2(-1.0), vec2(1.0), greaterThanEqual(square, vec2(0.0))) * (1.0 - abs(square.yx));
  return normalize(vec3(height < 0.0 ? unfolded : square, height));
}
float ridge_of(int shade) { return float(shade >> 24) / 127.0; }

void main() {
  bool still = cell_size == 0.0;
  vec4 seen = model_view * vec4(position + cell_size * displacement, 1.0);
  seen_position = seen.xyz;
  int seen_shade = still ? shade : displaced_shade;
  seen_normal = mat3(model_view) * normal_of(seen_shade);
  seen_ridge = ridge_of(seen_shade);
  original_position = position;
  value = marked_value / 127.0;
  tint = marked_tint;
  overlay = float(marked_overlay & 1) *
            vec4(vec3(ivec3(marked_overlay) >> ivec3(12, 8, 4) & 15) / 15.0, 1.0);
  hatched = float(marked_overlay >> 1 & 1);
  moved = still ? 0.0 : dot(displacement, normal_of(shade));
  scan_colour = still ? colour.rgb : displaced_colour.rgb;
#ifdef TEXTURES
  texel_change = still ? vec4(0.0, 0.0, 0.0, 1.0) : displaced_texel;
  texel_position = position;
#endif
  gl_Position = projection * seen;
}
)"_glsl;

}  // namespace burnish
