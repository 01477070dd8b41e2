#include <algorithm>
#include <numbers>

#include "client/app/panels/panels.h"
#include "client/app/widgets/places.h"
#include "client/app/widgets/theme.h"
#include "client/app/widgets/value_slider.h"
#include "client/model/documents/figures.h"
#include "client/tools/colours.h"
#include "common/edit/wavelength.h"

namespace burnish {
namespace {

/// Returns what became of the filter's α, as the wavelength of which half is left.
SliderChange draw_size(const Document& document, double& alpha, MessageLog& log) {
  const double least = kWaveCellsMin * document.cell_size(), most = document.diagonal();
  double size = std::clamp(wavelength_of_alpha(document.length_unit(), alpha), least, most);
  ImGui::TextUnformatted("Longest detail");
  hint("Colours that change over longer ways stay. In the scan's units");
  const SliderChange change = log_slider({{"Longest detail", least, most}, "%.3g", log}, size);
  if (change != SliderChange::kStill) alpha = alpha_of_wavelength(document.length_unit(), size);
  return change;
}

void draw_filter(Document& document, MessageLog& log) {
  ColourFilter changed = document.colour_filter();
  ImGui::TextUnformatted("Gradient scale of colours");
  hint(
      "Left evens the colours out, right makes them differ more. The shape does not move. Spots "
      "finer than a cell of the grid stay: a larger depth reaches them.");
  SliderChange change = beta_slider("Gradient scale of colours", changed.beta,
                                    to_imgui(blue_to_red(signed_part_of_beta(changed.beta))), log);
  change = std::max(change, draw_size(document, changed.alpha, log));
  if (change == SliderChange::kMoving) document.preview(SetColour{changed});
  if (change == SliderChange::kDone) document.commit(SetColour{changed});
}

void draw_texture(Document& document, MessageLog& log) {
  TextureFilter changed = document.texture();
  ImGui::TextUnformatted("Texture gain");
  hint(
      "Details of the colours that are finer than a cell of the grid: left fades them, right makes "
      "them stronger");
  SliderChange change =
      linear_slider({{"Texture gain", 0, kTextureGainMax}, "%.2f", log}, changed.gain);
  ImGui::TextUnformatted("Remove light");
  hint("How much goes of the light that was there when the colours were taken");
  change =
      std::max(change, linear_slider({{"Remove light", 0, 1}, "%.2f", log}, changed.remove_light));
  if (document.has_pictures()) {
    ImGui::TextUnformatted("Level seams");
    hint("How much goes of the steps of brightness between photos. The server bakes them anew");
    change =
        std::max(change, linear_slider({{"Level seams", 0, 1}, "%.2f", log}, changed.level_seams));
  }
  if (change == SliderChange::kMoving) document.preview(SetTexture{changed});
  if (change == SliderChange::kDone) document.commit(SetTexture{changed});
}

}  // namespace

void ColourPanel::draw(Workspace& workspace) {
  Document& document = *workspace.document();
  if (document.colour() != ColourBy::kScan &&
      noted("Show colours", ImGui::Button("Show colours", {-1, 0})))
    document.set_colour(ColourBy::kScan);
  ImGui::BeginDisabled(document.is_viewer());
  draw_filter(document, workspace.log);
  if (noted("Keep colours", ImGui::Button("Keep colours", {-1, 0})))
    document.commit(SetColour{{document.colour_filter().alpha, 1}});
  hint("Sets the gradient scale to 1. Painted colours stay painted.");
  draw_texture(document, workspace.log);
  if (const std::string seams = seams_text(document); !seams.empty())
    faint_text("%s", seams.c_str());
  ImGui::EndDisabled();
}

}  // namespace burnish
