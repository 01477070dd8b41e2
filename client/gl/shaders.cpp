#include "client/gl/shaders.h"

namespace burnish {

const char* const kMeshVertexShader = R"(#version 330 core
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in float ridge;
uniform mat4 model_view;
uniform mat4 projection;
centroid out vec3 seen_position;  // camera space
centroid out vec3 seen_normal;
centroid out float seen_ridge;
void main() {
  vec4 seen = model_view * vec4(position, 1.0);
  seen_position = seen.xyz;
  seen_normal = mat3(model_view) * normal;
  seen_ridge = ridge;
  gl_Position = projection * seen;
}
)";

// Clay: a hemisphere of sky and ground, a key light from the upper left, a weak fill from the
// right, a broad highlight, a rim, and darker grooves.
const char* const kMeshFragmentShader = R"(#version 330 core
centroid in vec3 seen_position;
centroid in vec3 seen_normal;
centroid in float seen_ridge;
uniform bool flat_normals;
uniform bool edges;
out vec4 colour;

const vec3 kClay = vec3(0.50, 0.44, 0.37);
const vec3 kSky = vec3(0.42, 0.45, 0.50);
const vec3 kGround = vec3(0.16, 0.14, 0.13);
const vec3 kKeyLight = vec3(1.00, 0.95, 0.88);
const vec3 kFillLight = vec3(0.14, 0.16, 0.20);
const vec3 kToKey = normalize(vec3(-0.65, 0.60, 0.42));
const vec3 kToFill = normalize(vec3(0.80, 0.10, 0.45));

vec3 shade(vec3 n, vec3 to_eye, float ridge) {
  vec3 light = mix(kGround, kSky, 0.5 + 0.5 * n.y);
  light += kKeyLight * max(dot(n, kToKey), 0.0);
  light += kFillLight * max(dot(n, kToFill), 0.0);
  light *= 1.0 + (ridge < 0.0 ? 0.55 : 0.25) * ridge;
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
  float side = gl_FrontFacing || flat_normals ? 1.0 : -1.0;  // both sides of a surface are lit
  vec3 linear = shade(side * normalize(n), normalize(-seen_position), side * seen_ridge);
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
