#include "client/gl/glsl.h"
#include "client/gl/shaders.h"

namespace burnish {

const char* const kPagePixels = R"(
centroid in vec3 seen_position;
centroid in vec3 seen_normal;
centroid in float seen_ridge;
in vec3 original_position;
centroid in float value;
centroid in float tint;
centroid in vec4 overlay;
centroid in float hatched;
centroid in float moved;
centroid in vec3 scan_colour;  // sRGB
uniform bool parallel;         // orthographic
uniform bool flat_normals;
uniform bool edges;
uniform bool faded;
uniform int colouring;  // as Colouring
uniform vec2 displacement_ends;
uniform vec3 tint_colour;
uniform int ring_count;
uniform vec4 rings[8];  // centre, radius
uniform vec3 ring_colours[8];
layout(location = 0) out vec4 colour;
layout(location = 1) out vec4 geometry;  // as GBufferTarget

vec3 linear(vec3 srgb) { return pow(srgb, vec3(kGamma)); }

vec3 blue_to_red(float signed_part) {
  float part = clamp(signed_part, -1.0, 1.0);
  return mix(kPlain, part < 0.0 ? kBlue : kRed, abs(part));
}

vec3 surface_colour();

vec3 base_colour() {
  vec3 base = kBaseOfKind[light_kind];
  if (colouring == 1) base = blue_to_red(value);
  if (colouring == 2) base = blue_to_red(moved / (moved < 0.0 ? displacement_ends.x : displacement_ends.y));
  if (colouring == 3) base = surface_colour();
  if (overlay.a > 0.0) base = mix(base, linear(overlay.rgb / overlay.a), kOverlayStrength * overlay.a);
  bool is_stripe = fract((gl_FragCoord.x + gl_FragCoord.y) / kHatchPixels) < kStripePart;
  base = mix(base, kHeld, hatched * (is_stripe ? kStripeStrength : kBetweenStripesStrength));
  return mix(base, linear(tint_colour), kTintStrength * tint * (1.0 - hatched));
}

// Rings keep their width in pixels, whatever the distance. The fourth part is how much of the
// surface is left.
vec4 with_rings(vec4 below) {
  for (int i = 0; i < ring_count; ++i) {
    float away = distance(original_position, rings[i].xyz) - rings[i].w;
    float pixels = abs(away) / max(length(vec2(dFdx(away), dFdy(away))), 1e-12);
    below = mix(below, vec4(linear(ring_colours[i]), 0.0), 1.0 - smoothstep(kRingInnerPixels, kRingOuterPixels, pixels));
  }
  return below;
}

vec3 towards_eye(vec3 n, vec3 to_eye) {
  return normalize(n + max(kGrazing - dot(n, to_eye), 0.0) * to_eye);
}

// The normal in a frame whose z runs to the eye.
vec3 as_seen(vec3 n, vec3 to_eye) {
  vec3 right = normalize(cross(vec3(0.0, 1.0, 0.0), to_eye));
  return vec3(dot(n, right), dot(n, cross(to_eye, right)), dot(n, to_eye));
}

// Folds the sphere of directions to a square, from 0 to 1.
vec2 folded(vec3 n) {
  n /= abs(n.x) + abs(n.y) + abs(n.z);
  vec2 turned = mix(vec2(-1.0), vec2(1.0), greaterThanEqual(n.xy, vec2(0.0)));
  return 0.5 + 0.5 * (n.z < 0.0 ? (1.0 - abs(n.yx)) * turned : n.xy);
}

void main() {
  geometry = vec4(0.0);
  if (edges) {
    colour = vec4(kEdge, kEdgeStrength);
    return;
  }
  vec3 to_eye = parallel ? vec3(0.0, 0.0, 1.0) : normalize(-seen_position);
  vec3 n = normalize(flat_normals ? cross(dFdx(seen_position), dFdy(seen_position)) : seen_normal);
  // Both sides of a surface are lit. A triangle that is folded over shows its back, but its normals
  // are those of the surface around it.
  bool is_back = !gl_FrontFacing && dot(n, to_eye) < 0.0;
  float side = is_back && !flat_normals ? -1.0 : 1.0;
  n = towards_eye(side * n, to_eye);
  vec3 seen = as_seen(n, to_eye);
  Lit lit = light_of(base_colour(), n, seen, to_eye, side * seen_ridge);
  if (faded) lit.colour = mix(vec3(luminance(lit.colour)), vec3(0.45), 0.4);
  vec4 shown = with_rings(vec4(lit.colour, 1.0));
  colour = vec4(pow(clamp(shown.rgb, 0.0, 1.0), vec3(1.0 / kGamma)), 1.0);
  geometry = vec4(folded(n), lit.strength, shown.a);
}
)"_glsl;

}  // namespace burnish
