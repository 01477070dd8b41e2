#include <algorithm>

#include "client/model/documents/figures.h"
#include "client/panels/panels.h"
#include "common/edit/wavelength.h"

namespace burnish {
namespace {

constexpr Slider kScale = {
    "Gradient scale of colours",
    "Left evens the colours out, right makes them differ more. The shape does not move. Spots "
    "finer than a cell of the grid stay: a larger depth reaches them.",
    kBetaMin, kBetaMax, SliderScale::kBeta};
constexpr Slider kGain = {
    .name = "Texture gain",
    .hint =
        "Details of the colours that are finer than a cell of the grid: left fades them, right "
        "makes them stronger",
    .low = 0,
    .high = kTextureGainMax,
    .digits = 0};
constexpr Slider kLight = {
    .name = "Remove light",
    .hint = "How much goes of the light that was there when the colours were taken",
    .low = 0,
    .high = 1,
    .digits = 0};
constexpr Slider kSeams = {.name = "Level seams",
                           .hint =
                               "How much goes of the steps of brightness between photos. The "
                               "server bakes them anew",
                           .low = 0,
                           .high = 1,
                           .digits = 0};

/// Shows the filter's α as the wavelength of which half is left.
SliderChange show_size(const Document& document, double& alpha, Widgets& widgets) {
  const double least = kWaveCellsMin * document.cell_size(), most = document.diagonal();
  double size = std::clamp(wavelength_of_alpha(document.length_unit(), alpha), least, most);
  const SliderChange change = widgets.slider(
      {"Longest detail", "Colours that change over longer ways stay. In the scan's units", least,
       most, SliderScale::kLogarithmic},
      size);
  if (change != SliderChange::kStill) alpha = alpha_of_wavelength(document.length_unit(), size);
  return change;
}

void show_filter(Document& document, Widgets& widgets) {
  ColourFilter changed = document.colour_filter();
  const SliderChange beta = widgets.slider(kScale, changed.beta);
  const SliderChange size = show_size(document, changed.alpha, widgets);
  follow(std::max(beta, size), SetColour{changed}, document);
  if (widgets.button("Keep colours", "Sets the gradient scale to 1. Painted colours stay painted."))
    document.commit(SetColour{{changed.alpha, 1}});
}

void show_texture(Document& document, Widgets& widgets) {
  TextureFilter changed = document.texture();
  SliderChange change = widgets.slider(kGain, changed.gain);
  change = std::max(change, widgets.slider(kLight, changed.remove_light));
  if (document.has_pictures())
    change = std::max(change, widgets.slider(kSeams, changed.level_seams));
  follow(change, SetTexture{changed}, document);
  widgets.text(seams_text(document).c_str());
}

}  // namespace

void show_colours(Workspace& workspace, Widgets& widgets) {
  Document& document = *workspace.document();
  if (document.colour() != ColourBy::kScan && widgets.button("Show colours"))
    document.set_colour(ColourBy::kScan);
  widgets.enable(!document.is_viewer());
  show_filter(document, widgets);
  show_texture(document, widgets);
}

}  // namespace burnish
