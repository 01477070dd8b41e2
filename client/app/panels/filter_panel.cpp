#include <algorithm>
#include <cmath>
#include <cstdio>
#include <imgui.h>
#include <imgui_stdlib.h>

#include "client/app/panels/panels.h"
#include "client/app/widgets/places.h"
#include "client/app/widgets/theme.h"
#include "client/app/widgets/value_slider.h"
#include "client/tools/colours.h"
#include "client/tools/own_presets.h"
#include "common/base/fixed_text.h"
#include "common/edit/wavelength.h"

namespace burnish {

static bool draw_choice(const Preset& preset, const Document& document) {
  const bool is_chosen = noted(preset.name, ImGui::Selectable(preset.name.c_str()));
  hint((preset.description + ". " + effect_of(preset, document.lengths()) + ".").c_str());
  return is_chosen;
}

void FilterPanel::draw_presets(Workspace& workspace) {
  Document& document = *workspace.document();
  MessageLog& log = workspace.log;
  ImGui::SetNextItemWidth(-1);
  const auto shown = document.preset_in_force(own_);
  const std::string title = shown ? shown->preset.name : "Presets";
  if (noted("Presets",
            ImGui::BeginCombo("##presets", title.c_str(), ImGuiComboFlags_HeightLarge))) {
    if (ImGui::IsWindowAppearing()) {
      read_own(log);
      document.measure_noise();
    }
    for (const Preset& preset : own_)
      if (draw_choice(preset, document)) document.apply(preset);
    if (!own_.empty()) ImGui::Separator();
    for (const Preset& preset : presets())
      if (draw_choice(preset, document)) document.apply(preset);
    ImGui::Separator();
    draw_own(document, log);
    ImGui::EndCombo();
  }
  if (document.waits_for_preset()) faint_text("measuring the scan's noise");
  if (shown) draw_strength(workspace, *shown);
}

void FilterPanel::draw_strength(Workspace& workspace, const PresetInForce& shown) {
  Document& document = *workspace.document();
  if (shown.preset.beta == 1 && shown.preset.bands.empty()) return;
  double strength = shown.strength;
  ImGui::TextUnformatted("Strength");
  ImGui::SameLine();
  faint_text("%s of the preset", std::string(strength_word(strength)).c_str());
  hint((effect_of(shown.preset, document.lengths()) + ", at full strength.").c_str());
  const SliderChange change =
      linear_slider({{"Strength of the preset", 0, 1}, 0, workspace.log}, strength);
  if (change != SliderChange::kStill) document.preview_strength(shown.preset, strength);
  if (change == SliderChange::kDone) document.commit_strength(shown.preset);
  pictures_.draw(workspace, shown);
}

void FilterPanel::draw_own(const Document& document, MessageLog& log) {
  ImGui::SetNextItemWidth(-em(4));
  ImGui::InputTextWithHint("##own", "name for this filter", &own_name_);
  ImGui::SameLine();
  ImGui::BeginDisabled(own_name_.empty());
  if (ImGui::Button("Keep", {-1, 0})) {
    const Preset preset = own_preset(own_name_, document.filter(), document.lengths());
    const Status saved = save_own_preset(own_presets_path(), preset);
    if (saved.is_ok()) {
      own_name_.clear();
      read_own(log);
    } else {
      log.failure("preset", saved);
    }
  }
  ImGui::EndDisabled();
  hint("Keeps the gradient scale, the curve and the bands as a preset of your own");
  draw_delete(document, log);
}

void FilterPanel::draw_delete(const Document& document, MessageLog& log) {
  const auto shown = document.preset_in_force(own_);
  if (!shown) return;
  const std::string name = shown->preset.name;
  if (std::ranges::none_of(own_, [&](const Preset& own) { return own.name == name; })) return;
  const std::string label = "Delete " + name;
  const bool is_pressed = noted("Delete preset", ImGui::Button(label.c_str(), {-1, 0}));
  hint("Deletes this preset of your own. The surface stays as it is.");
  if (!is_pressed) return;
  const Status deleted = delete_own_preset(own_presets_path(), name);
  if (!deleted.is_ok()) return log.failure("preset", deleted);
  read_own(log);
}

void FilterPanel::read_own(MessageLog& log) {
  auto own = read_own_presets(own_presets_path());
  if (own.is_ok()) {
    own_ = std::move(own).value();
  } else {
    log.failure("presets", own.status());
  }
}

static constexpr const char* kBetaHint =
    "How much the whole surface is smoothed or sharpened, but for what is painted: on the left it "
    "is "
    "smoothed, in the middle it stays, on the right it is sharpened. Its slopes are multiplied by "
    "β.";

static void draw_beta(Document& document, MessageLog& log) {
  ImGui::TextUnformatted("Gradient scale β");
  hint(kBetaHint);
  ImGui::SameLine();
  faint_text(document.beta() < 1 ? "smooths" : document.beta() > 1 ? "sharpens" : "keeps");
  double beta = document.beta();
  const ImVec4 colour = to_imgui(blue_to_red(signed_part_of_beta(beta)));
  const SliderChange change = beta_slider("Gradient scale β", beta, colour, log);
  if (change != SliderChange::kStill) document.preview_beta(beta);
  if (change == SliderChange::kDone) document.commit_beta();
}

// The fidelity α as a length, which a user can measure on the scan.
static void draw_fidelity(Document& document, MessageLog& log) {
  ImGui::TextUnformatted("Wavelength");
  ImGui::SameLine();
  CurveEditor& curve = document.curve();
  faint_text("fidelity α %s", fixed_text(curve.fidelity(), 3).c_str());
  hint(
      "In the scan's units. Waves of this length on the surface change by half, shorter ones more; "
      "longer waves stay. The slider begins at two cells of the grid.");
  const auto wavelength_of = [unit = document.length_unit()](double alpha) {
    return wavelength_of_alpha(unit, alpha);
  };
  double wavelength = wavelength_of(curve.fidelity());
  const TypedValue limits{"Wavelength", wavelength_of(curve.alpha_max()),
                          wavelength_of(kFidelityMin)};
  const SliderChange change = log_slider({limits, 3, log}, wavelength);
  if (change != SliderChange::kStill) {
    curve.set_fidelity(alpha_of_wavelength(document.length_unit(), wavelength));
    document.preview_curve();
  }
  if (change == SliderChange::kDone) document.commit_curve();
}

void FilterPanel::draw(Workspace& workspace) {
  Document& document = *workspace.document();
  ImGui::BeginDisabled(document.is_viewer());
  draw_presets(workspace);
  draw_beta(document, workspace.log);
  draw_fidelity(document, workspace.log);
  ImGui::EndDisabled();
}

}  // namespace burnish
