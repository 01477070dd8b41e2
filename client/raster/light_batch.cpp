#include "client/raster/shade_batch.h"
#include "client/raster/shade_math.h"
#include "common/base/dispatch.h"

namespace burnish {
namespace {

// The formulas of client/gl/page_light_shader.cpp and page_pixel_shader.cpp, with their names.

struct Lit {
  ShadeVector colour;
  float strength;
};

struct Surface {
  ShadeVector base;
  ShadeVector n;
  ShadeVector seen;  // the normal in a frame whose z runs to the eye
  ShadeVector to_eye;
  float ridge;
};

}  // namespace

BURNISH_SHADE static ShadeVector lamp_highlight(const LightTerms& terms, Surface at) {
  const float facing = greater(dot(at.n, unit(terms.to_lamp + at.to_eye)), 0);
  const float to_4 = facing * facing * facing * facing, to_8 = to_4 * to_4;
  return (terms.specular * to_8 * to_8 * to_8 * to_4) * shade::kKeyLight;
}

BURNISH_SHADE static Lit lamp(const LightTerms& terms, Surface at) {
  ShadeVector light = mixed(shade::kGround, shade::kSky, 0.5f + 0.5f * at.n.y);
  light = light + greater(dot(at.n, terms.to_lamp), 0) * shade::kKeyLight;
  light = light + greater(dot(at.n, unit(shade::kFillPlace)), 0) * shade::kFillLight;
  light = (1 + (at.ridge < 0 ? 0.55f : 0.25f) * at.ridge) * light;
  const float grazing = 1 - greater(dot(at.n, at.to_eye), 0);
  const float rim = grazing * grazing * grazing;
  return {by_parts(at.base, light) + lamp_highlight(terms, at) + (0.07f * rim) * shade::kSky,
          lesser(luminance(light) / 1.6f, 1)};
}

BURNISH_SHADE static Lit raking(const LightTerms& terms, Surface at) {
  const ShadeVector light = 0.2f * mixed(shade::kGround, shade::kSky, 0.5f + 0.5f * at.n.y) +
                            (1.7f * greater(dot(at.n, terms.to_lamp), 0)) * shade::kKeyLight;
  return {by_parts(at.base, light) + lamp_highlight(terms, at), lesser(luminance(light) / 1.7f, 1)};
}

BURNISH_SHADE static float window(ShadeVector n, float x, float y, float half_side) {
  const float away_x = __builtin_fabsf(2 * n.z * n.x - x);
  const float away_y = __builtin_fabsf(2 * n.z * n.y - y);
  return 1 - smooth_step(0.8f * half_side, half_side, greater(away_x, away_y));
}

BURNISH_SHADE static Lit ceramic(const LightTerms&, Surface at) {
  const float light =
      0.10f + 0.75f * smooth_step(-0.2f, 1, dot(at.seen, unit(shade::kCeramicLamp)));
  const float shine =
      0.35f * window(at.seen, -0.50f, 0.60f, 0.22f) + 0.12f * window(at.seen, 0.72f, 0.1f, 0.18f);
  return {light * at.base + ShadeVector{shine, shine, shine}, light / 0.85f};
}

BURNISH_SHADE static Lit bronze(const LightTerms&, Surface at) {
  const float mirrored = 2 * at.seen.z * at.seen.y;
  float light = 0.12f + 0.75f * power(greater(dot(at.seen, unit(shade::kBronzeLamp)), 0), 1.6f);
  light +=
      0.55f * smooth_step(0.30f, 0.75f, mirrored) + 0.18f * smooth_step(0.55f, 0.9f, -mirrored);
  const float facing = greater(dot(at.seen, unit(shade::kBronzeShine)), 0);
  const float to_4 = facing * facing * facing * facing, to_8 = to_4 * to_4, to_16 = to_8 * to_8;
  const float shine = 0.6f * to_16 * to_16 * to_16 * to_8 * to_4;
  return {(1.5f * light) * at.base + shine * shade::kBronzeGloss, light / 1.42f};
}

BURNISH_SHADE static Lit slopes(const LightTerms&, Surface at) {
  ShadeVector n = at.seen;
  const ShadeVector lamps{n.y, -0.87f * n.x - 0.5f * n.y, 0.87f * n.x - 0.5f * n.y};
  const float even = 0.50f + 0.15f * n.y, depth = mixed(0.75f, 1, n.z);
  const ShadeVector light = depth * (ShadeVector{even, even, even} + 0.45f * lamps);
  const ShadeVector bounded{greater(light.x, 0.04f), greater(light.y, 0.04f),
                            greater(light.z, 0.04f)};
  return {by_parts(at.base, bounded), luminance(light) / 1.3f};
}

BURNISH_SHADE static Surface surface_at(const LightTerms& terms, const ShadeBatch& batch, int i) {
  const ShadeVector to_eye = unit({batch.eye_x[i], batch.eye_y[i], batch.eye_z[i]});
  ShadeVector n = unit({batch.normal_x[i], batch.normal_y[i], batch.normal_z[i]});
  const float backwards = dot(n, to_eye) * terms.turns_back;
  const float side = ((batch.facing[i] < 0) & (backwards < 0)) ? -1.0f : 1.0f;
  n = side * n;
  n = unit(n + greater(shade::kGrazing - dot(n, to_eye), 0) * to_eye);
  const ShadeVector right = unit(cross({0, 1, 0}, to_eye));
  return {{batch.base_r[i], batch.base_g[i], batch.base_b[i]},
          n,
          {dot(n, right), dot(n, cross(to_eye, right)), dot(n, to_eye)},
          to_eye,
          side * batch.ridge[i] * terms.by_ridge};
}

BURNISH_SHADE static void store(const LightTerms& terms, Surface at, Lit lit, ShadeBatch& batch,
                                int i) {
  const float grey = mixed(luminance(lit.colour), 0.45f, 0.4f);
  const ShadeVector faded = mixed(lit.colour, {grey, grey, grey}, terms.fading);
  const float left = batch.left[i];
  batch.red[i] = power(clamped(left * faded.x + batch.over_r[i]), 1 / shade::kGamma);
  batch.green[i] = power(clamped(left * faded.y + batch.over_g[i]), 1 / shade::kGamma);
  batch.blue[i] = power(clamped(left * faded.z + batch.over_b[i]), 1 / shade::kGamma);
  batch.shown_x[i] = at.n.x;
  batch.shown_y[i] = at.n.y;
  batch.shown_z[i] = at.n.z;
  batch.strength[i] = clamped(lit.strength);
}

template <typename Light>
BURNISH_SHADE static void light_each(const LightTerms& given, ShadeBatch& batch,
                                     const Light& light) {
  const LightTerms terms = given;  // nothing that is written may change it
  const int count = (batch.count + 15) / 16 * 16;
  for (int i = 0; i < count; ++i) {
    const Surface at = surface_at(terms, batch, i);
    store(terms, at, light(terms, at), batch, i);
  }
}

BURNISH_DISPATCH
void light_batch(const LightTerms& terms, ShadeBatch& batch) {
  switch (terms.kind) {
    case LightKind::kRaking:
      return light_each(
          terms, batch, [](const LightTerms& t, Surface at) __attribute__((always_inline)) {
            return raking(t, at);
          });
    case LightKind::kCeramic:
      return light_each(
          terms, batch, [](const LightTerms& t, Surface at) __attribute__((always_inline)) {
            return ceramic(t, at);
          });
    case LightKind::kBronze:
      return light_each(
          terms, batch, [](const LightTerms& t, Surface at) __attribute__((always_inline)) {
            return bronze(t, at);
          });
    case LightKind::kSlopes:
      return light_each(
          terms, batch, [](const LightTerms& t, Surface at) __attribute__((always_inline)) {
            return slopes(t, at);
          });
    case LightKind::kUnlit:
      return light_each(
          terms, batch, [](const LightTerms&, Surface at) __attribute__((always_inline)) {
            return Lit{at.base, 1};
          });
    default:
      return light_each(
          terms, batch, [](const LightTerms& t, Surface at) __attribute__((always_inline)) {
            return lamp(t, at);
          });
  }
}

}  // namespace burnish
