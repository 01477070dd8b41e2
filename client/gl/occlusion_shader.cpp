#include "client/gl/glsl.h"
#include "client/gl/shaders.h"

namespace burnish {

// Ambient occlusion from the first sample of each pixel, on a spiral that 4x4 pixels turn in 16
// ways. The shader of the G-buffer blurs over these 16, so a still picture and a moving one have no
// noise. client/raster/occlusion_rows.cpp has the same formulas for processors.
const char* const kOcclusionPixels = R"(
out vec4 occluded;

const int kSteps = 12;
const float kReach = 0.07;  // of the picture's height

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  Place at = place_at(pixel, 0);
  occluded = vec4(0.0);
  if (at.away == 0.0) return;
  float pixels = kReach * float(size.y);
  float reach = pixels * pixel_length(at);
  float turn = float((pixel.x & 3) * 4 + (pixel.y & 3)) * 6.2832 / 16.0;
  float sum = 0.0;
  for (int i = 0; i < kSteps; ++i) {
    float part = (float(i) + 0.5) / float(kSteps);
    float angle = turn + 2.39996 * float(i);
    ivec2 there = pixel + ivec2(round(part * pixels * vec2(cos(angle), sin(angle))));
    if (any(lessThan(there, ivec2(0))) || any(greaterThanEqual(there, size))) continue;
    Place other = place_at(there, 0);
    if (other.away == 0.0) continue;
    vec3 to_other = other.position - at.position;
    float far = length(to_other) / reach;
    sum += max(dot(to_other / max(length(to_other), 1e-9), at.n) - 0.08, 0.0) *
           max(1.0 - far * far, 0.0);
  }
  occluded = vec4(min(8.0 * sum / float(kSteps), 1.0));
}
)"_glsl;

}  // namespace burnish
