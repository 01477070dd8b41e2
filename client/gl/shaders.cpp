#include "client/gl/shaders.h"

namespace burnish {

const char* const kMeshVertexShader = R"(#version 330 core
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
uniform mat4 model_view;
uniform mat4 projection;
out vec3 seen_position;  // camera space
out vec3 seen_normal;
void main() {
  vec4 seen = model_view * vec4(position, 1.0);
  seen_position = seen.xyz;
  seen_normal = mat3(model_view) * normal;
  gl_Position = projection * seen;
}
)";

// Clay: a hemisphere of sky and ground, a key light from the upper left, a weak fill from the
// right, a broad highlight, a rim, and darker grooves where the normals of neighbouring pixels
// converge.
const char* const kMeshFragmentShader = R"(#version 330 core
in vec3 seen_position;
in vec3 seen_normal;
uniform bool flat_normals;
uniform bool edges;
out vec4 colour;

const vec3 kClay = vec3(0.60, 0.50, 0.39);
const vec3 kSky = vec3(0.52, 0.55, 0.60);
const vec3 kGround = vec3(0.20, 0.17, 0.15);
const vec3 kKeyLight = vec3(1.05, 0.99, 0.90);
const vec3 kFillLight = vec3(0.14, 0.16, 0.20);
const vec3 kToKey = normalize(vec3(-0.60, 0.62, 0.50));
const vec3 kToFill = normalize(vec3(0.80, 0.10, 0.45));

// Curvature across the picture, from -1 (groove) to 1 (ridge).
float cavity(vec3 n) {
  vec2 pixel = max(vec2(abs(dFdx(seen_position).x), abs(dFdy(seen_position).y)), 1e-6);
  float divergence = dFdx(n).x / pixel.x + dFdy(n).y / pixel.y;
  return clamp(0.012 * divergence, -1.0, 1.0);
}

vec3 shade(vec3 n, vec3 to_eye, float ridge) {
  vec3 light = mix(kGround, kSky, 0.5 + 0.5 * n.y);
  light += kKeyLight * max(dot(n, kToKey), 0.0);
  light += kFillLight * max(dot(n, kToFill), 0.0);
  light *= 1.0 + (ridge < 0.0 ? 0.45 : 0.20) * ridge;
  float facing = max(dot(n, to_eye), 0.0);
  float highlight = pow(max(dot(n, normalize(kToKey + to_eye)), 0.0), 28.0);
  float rim = pow(1.0 - facing, 3.0);
  return kClay * light + 0.06 * highlight * kKeyLight + 0.07 * rim * kSky;
}

void main() {
  if (edges) {
    colour = vec4(0.05, 0.06, 0.08, 0.55);
    return;
  }
  vec3 n = flat_normals ? cross(dFdx(seen_position), dFdy(seen_position)) : seen_normal;
  n = normalize(n);
  vec3 to_eye = normalize(-seen_position);
  float side = dot(n, to_eye) < 0.0 ? -1.0 : 1.0;
  float ridge = flat_normals ? 0.0 : side * cavity(n);
  vec3 linear = shade(side * n, to_eye, ridge);
  colour = vec4(pow(min(linear, 1.0), vec3(1.0 / 2.2)), 1.0);
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
