#include "client/gl/glsl.h"
#include "client/gl/shaders.h"

namespace burnish {

// Clay: a hemisphere of sky and ground, a key light, a weak fill from the right, a broad highlight,
// a rim, and darker grooves. A matcap is a formula of the normal as the eye sees it.
// client/raster/light_batch.cpp has the same formulas for processors.
const char* const kPageLights = R"(
uniform int light_kind;  // as LightKind
uniform vec3 to_lamp;
uniform float specular;

const vec3 kBaseOfKind[8] = vec3[8](kClayBase, kClayBase, kClayBase, kClayBase, kCeramicBase,
    kBronzeBase, kSlopesBase, kClayBase);

struct Lit {
  vec3 colour;
  float strength;  // of the light alone, 0 to 1
};

float luminance(vec3 colour) { return dot(colour, vec3(0.21, 0.72, 0.07)); }

vec3 lamp_highlight(vec3 n, vec3 to_eye) {
  return specular * pow(max(dot(n, normalize(to_lamp + to_eye)), 0.0), 28.0) * kKeyLight;
}

Lit lamp(vec3 base, vec3 n, vec3 to_eye, float ridge) {
  vec3 light = mix(kGround, kSky, 0.5 + 0.5 * n.y);
  light += kKeyLight * max(dot(n, to_lamp), 0.0);
  light += kFillLight * max(dot(n, normalize(kFillPlace)), 0.0);
  light *= 1.0 + (ridge < 0.0 ? 0.55 : 0.25) * ridge;
  float rim = pow(1.0 - max(dot(n, to_eye), 0.0), 3.0);
  return Lit(base * light + lamp_highlight(n, to_eye) + 0.07 * rim * kSky,
             min(luminance(light) / 1.6, 1.0));
}

Lit raking(vec3 base, vec3 n, vec3 to_eye) {
  vec3 light = 0.2 * mix(kGround, kSky, 0.5 + 0.5 * n.y) + 1.7 * kKeyLight * max(dot(n, to_lamp), 0.0);
  return Lit(base * light + lamp_highlight(n, to_eye), min(luminance(light) / 1.7, 1.0));
}

// Whether the eye sees a bright square by reflection: its middle and half its side.
float window(vec3 n, vec2 middle, float half_side) {
  vec2 away = abs(2.0 * n.z * n.xy - middle);
  return 1.0 - smoothstep(0.8 * half_side, half_side, max(away.x, away.y));
}

Lit ceramic(vec3 base, vec3 n) {
  float light = 0.10 + 0.75 * smoothstep(-0.2, 1.0, dot(n, normalize(kCeramicLamp)));
  float shine = 0.35 * window(n, vec2(-0.50, 0.60), 0.22) + 0.12 * window(n, vec2(0.72, 0.1), 0.18);
  return Lit(base * light + shine, light / 0.85);
}

Lit bronze(vec3 base, vec3 n) {
  float mirrored = 2.0 * n.z * n.y;
  float light = 0.12 + 0.75 * pow(max(dot(n, normalize(kBronzeLamp)), 0.0), 1.6);
  light += 0.55 * smoothstep(0.30, 0.75, mirrored) + 0.18 * smoothstep(-0.55, -0.9, mirrored);
  float shine = 0.6 * pow(max(dot(n, normalize(kBronzeShine)), 0.0), 60.0);
  return Lit(base * 1.5 * light + shine * kBronzeGloss, light / 1.42);
}

Lit slopes(vec3 base, vec3 n) {
  vec3 lamps = vec3(n.y, -0.87 * n.x - 0.5 * n.y, 0.87 * n.x - 0.5 * n.y);  // red from above
  vec3 light = (0.50 + 0.15 * n.y + 0.45 * lamps) * mix(0.75, 1.0, n.z);
  return Lit(base * max(light, 0.04), luminance(light) / 1.3);
}

// `seen` is the normal in the frame of the eye's ray: z runs to the eye.
Lit light_of(vec3 base, vec3 n, vec3 seen, vec3 to_eye, float ridge) {
  if (light_kind == 3) return raking(base, n, to_eye);
  if (light_kind == 4) return ceramic(base, seen);
  if (light_kind == 5) return bronze(base, seen);
  if (light_kind == 6) return slopes(base, seen);
  if (light_kind == 7) return Lit(base, 1.0);
  return lamp(base, n, to_eye, light_kind == 0 ? ridge : 0.0);
}
)"_glsl;

}  // namespace burnish
