#include "client/gl/glsl.h"
#include "client/gl/shaders.h"

namespace burnish {

const char* const kPageTexels = R"(
#ifdef TEXTURES
centroid in vec4 texel_change;    // its light, and the gain
centroid in vec3 texel_position;  // as original_position, but never outside the triangle
uniform vec4 chart[3];  // u and v, to texels; the layer, and 1 if there is one
uniform sampler2DArray sheets;

// Chooses between levels by itself: drivers and processors then agree.
vec3 sheet_colour(vec3 right, vec3 up) {
  vec4 u = chart[0], v = chart[1], at = vec4(texel_position, 1.0);
  vec3 place = vec3(vec2(dot(u, at), dot(v, at)) / 1024.0, chart[2].x);
  vec2 across = vec2(dot(u.xyz, right), dot(v.xyz, right));
  vec2 upwards = vec2(dot(u.xyz, up), dot(v.xyz, up));
  float texels = max(max(dot(across, across), dot(upwards, upwards)), 1.0);
  float detail = min(0.5 * log2(texels), 2.0);
  float fine = floor(detail);
  return mix(textureLod(sheets, place, fine).rgb,
             textureLod(sheets, place, min(fine + 1.0, 2.0)).rgb, detail - fine);
}

vec3 surface_colour() {
  vec3 right = dFdx(original_position), up = dFdy(original_position);
  if (chart[2].y == 0.0) return linear(scan_colour);
  return max(texel_change.a * linear(sheet_colour(right, up)) + texel_change.rgb, 0.0);
}
#else
vec3 surface_colour() { return linear(scan_colour); }
#endif
)"_glsl;

}  // namespace burnish
