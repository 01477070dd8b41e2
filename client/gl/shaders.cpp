#include "client/gl/shaders.h"

namespace burnish {

// Clay: a hemisphere of sky and ground, a key light from the upper left, a weak fill from the
// right, a broad highlight, a rim, and darker grooves.
const char* const kPageFragmentShader = R"(#version 330 core
centroid in vec3 seen_position;
centroid in vec3 seen_normal;
centroid in float seen_ridge;
in vec3 original_position;
centroid in float value;
centroid in float tint;
centroid in float moved;
centroid in vec3 scan_colour;  // sRGB
uniform bool flat_normals;
uniform bool edges;
uniform bool faded;
uniform int colouring;  // as Colouring
uniform float displacement_range;
uniform vec3 tint_colour;
uniform int ring_count;
uniform vec4 rings[8];  // centre, radius
uniform vec3 ring_colours[8];
out vec4 colour;

const vec3 kClay = vec3(0.50, 0.44, 0.37);
const vec3 kPlain = vec3(0.62, 0.62, 0.62);
const vec3 kBlue = vec3(0.03, 0.16, 0.72);
const vec3 kRed = vec3(0.72, 0.04, 0.03);
const vec3 kSky = vec3(0.42, 0.45, 0.50);
const vec3 kGround = vec3(0.16, 0.14, 0.13);
const vec3 kKeyLight = vec3(1.00, 0.95, 0.88);
const vec3 kFillLight = vec3(0.14, 0.16, 0.20);
const vec3 kToKey = normalize(vec3(-0.65, 0.60, 0.42));
const vec3 kToFill = normalize(vec3(0.80, 0.10, 0.45));

vec3 linear(vec3 srgb) { return pow(srgb, vec3(2.2)); }

vec3 shade(vec3 base, vec3 n, vec3 to_eye, float ridge) {
  vec3 light = mix(kGround, kSky, 0.5 + 0.5 * n.y);
  light += kKeyLight * max(dot(n, kToKey), 0.0);
  light += kFillLight * max(dot(n, kToFill), 0.0);
  light *= 1.0 + (ridge < 0.0 ? 0.55 : 0.25) * ridge;
  float facing = max(dot(n, to_eye), 0.0);
  float highlight = pow(max(dot(n, normalize(kToKey + to_eye)), 0.0), 28.0);
  float rim = pow(1.0 - facing, 3.0);
  return base * light + 0.06 * highlight * kKeyLight + 0.07 * rim * kSky;
}

vec3 blue_to_red(float signed_part) {
  float part = clamp(signed_part, -1.0, 1.0);
  return mix(kPlain, part < 0.0 ? kBlue : kRed, abs(part));
}

vec3 base_colour() {
  vec3 base = kClay;
  if (colouring == 1) base = blue_to_red(value);
  if (colouring == 2) base = blue_to_red(moved / displacement_range);
  if (colouring == 3) base = linear(scan_colour);
  return mix(base, linear(tint_colour), 0.75 * tint);
}

// Rings keep their width in pixels, whatever the distance.
vec3 with_rings(vec3 below) {
  for (int i = 0; i < ring_count; ++i) {
    float away = distance(original_position, rings[i].xyz) - rings[i].w;
    float pixels = abs(away) / max(length(vec2(dFdx(away), dFdy(away))), 1e-12);
    below = mix(below, linear(ring_colours[i]), 1.0 - smoothstep(0.8, 1.8, pixels));
  }
  return below;
}

void main() {
  if (edges) {
    colour = vec4(0.05, 0.06, 0.08, 0.55);
    return;
  }
  vec3 n = flat_normals ? cross(dFdx(seen_position), dFdy(seen_position)) : seen_normal;
  // Both sides of a surface are lit. A triangle that is folded over shows its back, but its normals
  // are those of the surface around it.
  bool is_back = !gl_FrontFacing && dot(seen_normal, seen_position) > 0.0;
  float side = is_back && !flat_normals ? -1.0 : 1.0;
  vec3 lit = shade(base_colour(), side * normalize(n), normalize(-seen_position),
                   side * seen_ridge);
  if (faded) lit = mix(vec3(dot(lit, vec3(0.30, 0.59, 0.11))), vec3(0.45), 0.4);
  colour = vec4(pow(min(with_rings(lit), 1.0), vec3(1.0 / 2.2)), 1.0);
}
)";

const char* const kBackgroundVertexShader = R"(#version 330 core
out float height;
void main() {
  vec2 corner = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
  height = 0.5 + 0.5 * corner.y;
  gl_Position = vec4(corner, 0.0, 1.0);
}
)";

const char* const kBackgroundFragmentShader = R"(#version 330 core
in float height;
out vec4 colour;
void main() {
  colour = vec4(mix(vec3(0.70, 0.72, 0.75), vec3(0.93, 0.94, 0.95), height), 1.0);
}
)";

}  // namespace burnish
