#include "client/app/colour_bar.h"

#include <algorithm>
#include <cstdio>

#include "client/app/places.h"
#include "client/app/theme.h"
#include "client/report/length_text.h"
#include "client/tools/colours.h"

namespace burnish {

namespace {

constexpr float kBarWidthEm = 14, kBarHeightEm = 0.8f;

/// A legend of the colours: texts at -1, 0 and 1, and the value under the pointer.
struct Scale {
  std::string title, low, middle, high;
  double part = 0;  // of the pointer, -1 to 1
  std::string value;
};

std::string short_number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", value);
  return text;
}

Scale beta_scale(const SurfaceHit* hit) {
  Scale scale{"gradient scale β", "0", "1", "3"};
  if (hit == nullptr) return scale;
  scale.part = hit->mark / 127;
  scale.value = short_number(beta_of_signed_part(scale.part));
  return scale;
}

// The window's κ is times L; a user measures 1/length.
Scale curvature_scale(const Document& document, const SurfaceHit* hit) {
  const double range = document.curve().kappa_range(), unit = document.length_unit();
  const std::string per = document.unit().empty() ? "" : " 1/" + document.unit();
  const auto text = [&](double part) {
    return short_number(kappa_of_signed_part(part, range) / unit) + per;
  };
  Scale scale{"curvature", text(-1), "0", text(1)};
  if (hit == nullptr) return scale;
  scale.part = hit->mark / 127;
  scale.value = text(scale.part);
  return scale;
}

Scale displacement_scale(const Document& document, const ViewOptions& options,
                         const SurfaceHit* hit) {
  const double range = options.displacement_range * document.cell_size();
  Scale scale{"displacement", length_text(-range, document.unit()), "0",
              length_text(range, document.unit())};
  if (hit == nullptr) return scale;
  scale.part = std::clamp(hit->moved() / range, -1.0, 1.0);
  scale.value = length_text(hit->moved(), document.unit());
  return scale;
}

std::optional<Scale> scale_of(const Document& document, const Viewport& viewport) {
  const SurfaceHit* const hit = viewport.hover() ? &*viewport.hover() : nullptr;
  switch (document.colour()) {
    case ColourBy::kBeta:
      return beta_scale(hit);
    case ColourBy::kCurvature:
      return curvature_scale(document, hit);
    case ColourBy::kDisplacement:
      return displacement_scale(document, viewport.options, hit);
    case ColourBy::kNothing:
    case ColourBy::kScan:
      return std::nullopt;
  }
  return std::nullopt;
}

ImU32 colour_at(float part) {
  return ImGui::ColorConvertFloat4ToU32(to_imgui(blue_to_red(part)));
}

void draw_bar(const ImVec2& at) {
  ImDrawList* const list = ImGui::GetWindowDrawList();
  const float middle = at.x + em(kBarWidthEm / 2), right = at.x + em(kBarWidthEm);
  const float bottom = at.y + em(kBarHeightEm);
  const ImU32 blue = colour_at(-1), grey = colour_at(0), red = colour_at(1);
  list->AddRectFilledMultiColor(at, {middle, bottom}, blue, grey, grey, blue);
  list->AddRectFilledMultiColor({middle, at.y}, {right, bottom}, grey, red, red, grey);
}

void draw_mark(const ImVec2& at, const Scale& scale) {
  const float x = at.x + em(kBarWidthEm) * static_cast<float>(scale.part + 1) / 2;
  const float y = at.y + em(kBarHeightEm), side = em(0.35f);
  const ImU32 colour = ImGui::ColorConvertFloat4ToU32(theme::kText);
  ImGui::GetWindowDrawList()->AddTriangleFilled({x, y - side}, {x - side, y + side},
                                                {x + side, y + side}, colour);
}

void draw_ends(const Scale& scale) {
  const float left = ImGui::GetCursorPosX(), width = em(kBarWidthEm);
  ImGui::TextUnformatted(scale.low.c_str());
  ImGui::SameLine(left + (width - ImGui::CalcTextSize(scale.middle.c_str()).x) / 2);
  ImGui::TextUnformatted(scale.middle.c_str());
  ImGui::SameLine(left + width - ImGui::CalcTextSize(scale.high.c_str()).x);
  ImGui::TextUnformatted(scale.high.c_str());
}

}  // namespace

void ColourBar::draw(Workspace& workspace) {
  const auto scale = scale_of(*workspace.document(), workspace.viewport);
  if (!scale) return;
  const float margin = em(0.7f);
  ImGui::SetNextWindowPos({lower_right.x - margin, lower_right.y - margin}, 0, {1, 1});
  ImGui::SetNextWindowBgAlpha(0.86f);
  ImGui::Begin("##colour_bar", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoInputs |
                   ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoNav |
                   ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoSavedSettings);
  faint_text("%s", scale->title.c_str());
  if (!scale->value.empty()) {
    ImGui::SameLine();
    ImGui::TextUnformatted(scale->value.c_str());
  }
  const ImVec2 at = ImGui::GetCursorScreenPos();
  draw_bar(at);
  ImGui::Dummy({em(kBarWidthEm), em(kBarHeightEm + 0.3f)});
  if (!scale->value.empty()) draw_mark(at, *scale);
  draw_ends(*scale);
  note_window("Colour bar");
  ImGui::End();
}

}  // namespace burnish
