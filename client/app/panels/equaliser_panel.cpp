#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "client/app/panels/panels.h"
#include "client/app/widgets/places.h"
#include "client/app/widgets/theme.h"
#include "client/app/widgets/value_slider.h"
#include "client/tools/band_choice.h"
#include "common/edit/wavelength.h"

namespace burnish {
namespace {

constexpr double kGainShown = 3;  // the sliders' end; larger gains are typed

/// The sizes of detail that a scan has on its grid, file units.
struct SizeRange {
  double least, most;
};

SizeRange sizes_of(const Document& document) {
  return {kWaveCellsMin * document.cell_size(), document.diagonal()};
}

/// Draws by how much a wave is multiplied, over its length.
void draw_response(const Document& document) {
  constexpr int kSteps = 96;
  const SizeRange range = sizes_of(document);
  const ImVec2 low = ImGui::GetCursorScreenPos();
  const ImVec2 size = {ImGui::GetContentRegionAvail().x, em(5)};
  ImGui::Dummy(size);
  hint("How much of a wave is left or added, from two cells of the grid to the whole scan");
  std::vector<double> values;
  for (int i = 0; i <= kSteps; ++i)
    values.push_back(response(document.equaliser(), range.least * std::pow(range.most / range.least,
                                                                           double(i) / kSteps)));
  const double top = std::max(2.0, 1.1 * *std::max_element(values.begin(), values.end()));
  const auto y = [&](double value) { return low.y + size.y * float(1 - value / top); };
  ImDrawList* const list = ImGui::GetWindowDrawList();
  const ImU32 ground = ImGui::GetColorU32(ImGuiCol_FrameBg);
  list->AddRectFilled(low, {low.x + size.x, low.y + size.y}, ground, em(0.2f));
  const ImU32 faint = ImGui::ColorConvertFloat4ToU32(theme::kFaint);
  list->AddLine({low.x, y(1)}, {low.x + size.x, y(1)}, faint);
  std::vector<ImVec2> line;
  for (int i = 0; i <= kSteps; ++i)
    line.emplace_back(low.x + size.x * float(i) / kSteps, y(values[static_cast<size_t>(i)]));
  list->AddPolyline(line.data(), static_cast<int>(line.size()),
                    ImGui::GetColorU32(ImGuiCol_SliderGrabActive), 0, em(0.13f));
}

/// Returns what became of a band's gain.
SliderChange draw_gain(const Document& document, size_t number, double& gain, MessageLog& log) {
  faint_text("%s", details_of(document.equaliser(), number).c_str());
  const std::string name = "Gain of band " + std::to_string(number);
  return linear_slider({{name, kGainMin, std::max(kGainShown, gain)}, 0, log}, gain);
}

SliderChange draw_size(const Document& document, size_t number, double& size, MessageLog& log) {
  const std::vector<Band>& bands = document.equaliser().bands;
  const SizeRange range = sizes_of(document);
  const double least = number > 1 ? kBandRatioMin * bands[number - 2].size : range.least;
  const double most = number < bands.size() ? bands[number].size / kBandRatioMin : range.most;
  const std::string name = "Size of band " + std::to_string(number);
  if (least >= most) return SliderChange::kStill;
  return log_slider({{name, least, most}, 3, log}, size);
}

void draw_bands(Document& document, bool shows_sizes, MessageLog& log) {
  Equaliser changed = document.equaliser();
  SliderChange change = SliderChange::kStill;
  for (size_t number = 1; number <= changed.bands.size(); ++number) {
    Band& band = changed.bands[number - 1];
    change = std::max(change, draw_gain(document, number, band.gain, log));
    if (shows_sizes) change = std::max(change, draw_size(document, number, band.size, log));
  }
  if (change == SliderChange::kMoving) document.preview(SetEqualiser{changed});
  if (change == SliderChange::kDone) document.commit(SetEqualiser{changed});
}

void draw_buttons(Document& document) {
  const float half = (ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ItemSpacing.x) / 2;
  if (noted("All gains 1", ImGui::Button("All gains 1", {half, 0}))) {
    Equaliser level = document.equaliser();
    for (Band& band : level.bands) band.gain = 1;
    document.commit(SetEqualiser{level});
  }
  ImGui::SameLine();
  if (noted("Remove bands", ImGui::Button("Remove bands", {half, 0})))
    document.commit(SetEqualiser{});
}

}  // namespace

void EqualiserPanel::draw(Workspace& workspace) {
  Document& document = *workspace.document();
  ImGui::BeginDisabled(document.is_viewer());
  if (document.equaliser().bands.empty()) {
    const bool keeps_edges = document.edges().is_on();
    ImGui::BeginDisabled(keeps_edges);
    if (noted("Make bands", ImGui::Button("Make bands", {-1, 0})))
      document.commit(SetEqualiser{first_bands(document.cell_size(), document.diagonal())});
    ImGui::EndDisabled();
    hint("Splits the surface's detail by size. Each band gets a gain, and a brush can paint it.");
    if (keeps_edges) faint_text("%s", "Bands have the scan's noise. Keep no edges to make them.");
  } else {
    draw_response(document);
    draw_bands(document, shows_sizes_, workspace.log);
    ImGui::Checkbox("Sizes", &shows_sizes_);
    hint("Shows the size at which each band ends, in the scan's units");
    draw_buttons(document);
  }
  ImGui::EndDisabled();
}

}  // namespace burnish
