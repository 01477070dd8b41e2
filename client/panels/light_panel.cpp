#include <iterator>

#include "client/panels/panels.h"

namespace burnish {
namespace {

constexpr Option kLights[] = {
    {"clay", "Clay", "A lamp, the sky and a weak second lamp."},
    {"radiance", "Radiance scaling",
     "Brightens what bends outwards and darkens what bends inwards."},
    {"cavity", "Cavity", "Bright ridges and dark valleys."},
    {"raking", "Raking light", "One hard lamp. Low over the surface it shows the finest relief."},
    {"ceramic", "Ceramic", "White glaze with bright windows."},
    {"bronze", "Bronze", "Dark metal."},
    {"slopes", "Slopes", "Each direction of a slope has its own tone."},
    {"unlit", "Unlit", "The colours alone, without light."}};  // as LightKind

static_assert(std::size(kLights) == kLightKinds);

void choose_light(Lighting& lighting, Widgets& widgets) {
  const int taken = widgets.choice({"Light", kLights}, static_cast<int>(lighting.kind));
  if (taken >= 0) lighting.kind = static_cast<LightKind>(taken);
}

void show_strength(const char* name, double high, double& value, Widgets& widgets) {
  widgets.slider({name, "", 0, high, SliderScale::kLinear, 0}, value);
}

}  // namespace

void show_lighting(Lighting& lighting, Widgets& widgets) {
  choose_light(lighting, widgets);
  const bool has_lamp = lighting.kind <= LightKind::kRaking;
  if (has_lamp) widgets.lamp(lighting);
  if (lighting.kind == LightKind::kRadiance)
    show_strength("Scaling", kRadianceMax, lighting.radiance, widgets);
  if (lighting.kind == LightKind::kCavity) {
    show_strength("Ridges", kCavityMax, lighting.ridge, widgets);
    show_strength("Valleys", kCavityMax, lighting.valley, widgets);
  }
  if (has_lamp) show_strength("Highlight", 1, lighting.specular, widgets);
  show_strength("Occlusion", 1, lighting.occlusion, widgets);
  if (widgets.button("As at first")) lighting = {};
}

void show_light(Workspace& workspace, Widgets& widgets) {
  show_lighting(workspace.viewport.options.lighting, widgets);
}

}  // namespace burnish
