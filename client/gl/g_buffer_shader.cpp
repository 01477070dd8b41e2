#include "client/gl/glsl.h"
#include "client/gl/shaders.h"

namespace burnish {

const char* const kGBufferParts = R"(
uniform SurfaceSampler colours;
uniform SurfaceSampler geometries;
uniform SurfaceSampler depths;
uniform ivec2 size;
uniform vec4 depth_terms;   // of the projection: z by z, z by 1, w by z, w by 1
uniform vec2 half_view;     // half the picture at distance 1, or anywhere without perspective
uniform bool parallel;

struct Place {
  vec3 n;          // camera space
  float away;      // distance along the view; 0: nothing is there
  vec3 position;   // camera space
  float strength;  // of the light, 0 to 1
  float part;      // of the surface in the colour
};

vec3 unfolded(vec2 square) {
  square = 2.0 * square - 1.0;
  float height = 1.0 - abs(square.x) - abs(square.y);
  vec2 turned = mix(vec2(-1.0), vec2(1.0), greaterThanEqual(square, vec2(0.0)));
  return normalize(vec3(height < 0.0 ? (1.0 - abs(square.yx)) * turned : square, height));
}

// Returns a pixel's ray at distance 1.
vec2 across(ivec2 pixel) { return (2.0 * (vec2(pixel) + 0.5) / vec2(size) - 1.0) * half_view; }

Place place_at(ivec2 pixel, int index) {
  pixel = clamp(pixel, ivec2(0), size - 1);
  float depth = texelFetch(depths, pixel, index).r;
  vec4 geometry = texelFetch(geometries, pixel, index);
  // Edges reach past the surface, and have a depth alone.
  if (depth == 1.0 || geometry.xyz == vec3(0.0))
    return Place(vec3(0.0, 0.0, 1.0), 0.0, vec3(0.0), 0.0, 0.0);
  geometry.xyz /= covered_part(texelFetch(colours, pixel, index));
  float z = 2.0 * depth - 1.0;
  float away = (z * depth_terms.w - depth_terms.y) / (z * depth_terms.z - depth_terms.x);
  vec3 position = vec3(across(pixel) * (parallel ? 1.0 : away), -away);
  return Place(unfolded(geometry.xy), away, position, geometry.z, geometry.w);
}

vec3 to_eye_from(Place at) { return parallel ? vec3(0.0, 0.0, 1.0) : normalize(-at.position); }

float pixel_length(Place at) { return 2.0 * half_view.y / float(size.y) * (parallel ? 1.0 : at.away); }

// How far another place lies from the plane of this one, in pixels.
float off_plane(Place at, Place other) {
  float facing = max(dot(at.n, to_eye_from(at)), 0.2);
  return abs(dot(at.n, other.position - at.position)) / (facing * pixel_length(at));
}
)"_glsl;

// client/raster/g_buffer_rows.cpp has the same formulas for processors. Curvature is the divergence
// of the normal over three distances, so that fine and coarse detail count. Steps in depth count
// nothing.
const char* const kGBufferPixels = R"(
uniform sampler2D occlusions;
uniform int samples;
uniform int light_kind;  // as LightKind
uniform float radiance;
uniform float ridge;
uniform float valley;
uniform float occlusion;
out vec4 colour;

vec2 turn_to(Place at, ivec2 pixel, int index, ivec2 by) {
  Place other = place_at(pixel + by, index);
  if (other.away == 0.0) return vec2(0.0);
  float near = clamp(2.0 - off_plane(at, other) / (1.5 * length(vec2(by)) + 1.0), 0.0, 1.0);
  vec3 to_eye = to_eye_from(at);
  vec3 right = normalize(cross(vec3(0.0, 1.0, 0.0), to_eye));
  vec3 turn = other.n - at.n;
  return near * vec2(dot(turn, right), dot(turn, cross(to_eye, right)));
}

float curvature(Place at, ivec2 pixel, int index) {
  float sum = 0.0;
  for (int i = 0; i < 3; ++i) {
    int reach = max(int(float(i == 0 ? 1 : i == 1 ? 3 : 8) * float(size.y) / 900.0 + 0.5), 1);
    sum += turn_to(at, pixel, index, ivec2(reach, 0)).x - turn_to(at, pixel, index, ivec2(-reach, 0)).x;
    sum += turn_to(at, pixel, index, ivec2(0, reach)).y - turn_to(at, pixel, index, ivec2(0, -reach)).y;
  }
  return sum * smoothstep(0.05, 0.45, dot(at.n, to_eye_from(at)));
}

// Vergne et al. 2010, equation 3: 1 where the light is kInvariant, convex places become brighter
// where there is more light, and darker where there is less.
float radiance_scaling(float bend, float light) {
  const float kInvariant = 0.12;
  float up = exp(-radiance * bend);
  return (kInvariant * up + light * (1.0 - kInvariant * (1.0 + up))) /
         (kInvariant + light * (up - kInvariant * (1.0 + up)));
}

float cavity(float bend) {
  float size_of = abs(bend) / (1.0 + 1.5 * abs(bend));
  return max(1.0 + (bend > 0.0 ? 0.9 * ridge : -1.2 * valley) * size_of, 0.05);
}

float occlusion_at(Place at, ivec2 pixel) {
  float sum = 0.0, weights = 1e-4;
  for (int y = -2; y < 2; ++y)
    for (int x = -2; x < 2; ++x) {
      Place other = place_at(pixel + ivec2(x, y), 0);
      if (other.away == 0.0) continue;
      float weight = clamp(2.0 - off_plane(at, other) / 3.0, 0.0, 1.0);
      sum += weight * texelFetch(occlusions, clamp(pixel + ivec2(x, y), ivec2(0), size - 1), 0).r;
      weights += weight;
    }
  return sum / weights;
}

// Multiplies the colour in sRGB.
float light_around(Place at, ivec2 pixel, int index) {
  if (at.away == 0.0) return 1.0;
  float factor = 1.0;
  if (light_kind == 1)
    factor = radiance_scaling(tanh(1.2 * curvature(at, pixel, index)), at.strength);
  if (light_kind == 2) factor = cavity(curvature(at, pixel, index));
  if (occlusion > 0.0) factor *= 1.0 - occlusion * occlusion_at(at, pixel);
  return mix(1.0, pow(factor, 1.0 / kGamma), at.part);
}

bool is_one_surface(ivec2 pixel, Place first) {
  for (int i = 1; i < samples; ++i) {
    Place other = place_at(pixel, i);
    if ((other.away == 0.0) != (first.away == 0.0)) return false;
    if (first.away > 0.0 && off_plane(first, other) > 4.0) return false;
  }
  return true;
}

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  Place first = place_at(pixel, 0);
  bool once = is_one_surface(pixel, first);
  float factor = light_around(first, pixel, 0);
  vec3 sum = vec3(0.0);
  for (int i = 0; i < samples; ++i) {
    if (!once && i > 0) factor = light_around(place_at(pixel, i), pixel, i);
    sum += min(factor * texelFetch(colours, pixel, i).rgb, 1.0);
  }
  colour = vec4(sum / float(samples), 1.0);
}
)"_glsl;

}  // namespace burnish
