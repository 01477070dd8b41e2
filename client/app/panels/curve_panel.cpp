#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "client/app/panels/panels.h"
#include "client/app/widgets/places.h"
#include "client/app/widgets/theme.h"
#include "common/base/limits.h"

namespace burnish {
namespace {

using Eigen::Vector2d;

/// The plot's rectangle in the window. Places in it have x and y from 0 to 1, y upwards.
struct Plot {
  ImVec2 low;  // upper left
  ImVec2 size;

  ImVec2 at(const Vector2d& place) const {
    return {low.x + float(place.x()) * size.x, low.y + float(1 - place.y()) * size.y};
  }
  Vector2d place(const ImVec2& point) const {
    return {(point.x - low.x) / size.x, 1 - (point.y - low.y) / size.y};
  }
};

ImU32 colour(float r, float g, float b, float a = 1) {
  return ImGui::ColorConvertFloat4ToU32({r, g, b, a});
}

void draw_histogram(const Plot& plot, const ScanDescription& scan) {
  if (!scan.prepared || scan.prepared->histogram.empty()) return;
  const std::vector<float>& bins = scan.prepared->histogram;
  const float tallest = *std::max_element(bins.begin(), bins.end());
  if (tallest <= 0) return;
  ImDrawList* const list = ImGui::GetWindowDrawList();
  const auto count = static_cast<double>(bins.size());
  for (size_t i = 0; i < bins.size(); ++i) {
    // The root lifts the tails, which hold the detail that users edit.
    const double height = 0.92 * std::sqrt(bins[i] / tallest);
    list->AddRectFilled(plot.at({double(i) / count, height}), plot.at({double(i + 1) / count, 0}),
                        colour(0.36f, 0.44f, 0.54f, 0.75f));
  }
}

void draw_axes(const Plot& plot, double alpha_max) {
  ImDrawList* const list = ImGui::GetWindowDrawList();
  list->AddLine(plot.at({0.5, 0}), plot.at({0.5, 1}), colour(0.6f, 0.6f, 0.6f, 0.5f));
  const ImU32 text = colour(0.80f, 0.82f, 0.84f);           // the plot is dark in both themes
  const ImU32 behind = colour(0.09f, 0.10f, 0.11f, 0.85f);  // the histogram's bars are lighter
  const float pad = em(0.3f);
  const auto write = [&](const std::string& label, double across, double down) {
    const ImVec2 size = ImGui::CalcTextSize(label.c_str());
    const ImVec2 at{plot.low.x + pad + float(across) * (plot.size.x - size.x - 2 * pad),
                    plot.low.y + pad + float(down) * (plot.size.y - size.y - 2 * pad)};
    list->AddRectFilled(at, {at.x + size.x, at.y + size.y}, behind);
    list->AddText(at, text, label.c_str());
  };
  write("α " + std::to_string(std::lround(alpha_max)), 0, 0);
  write("1", 0, 1);
  write("convex κ →", 1, 0);
}

void draw_curve(const Plot& plot, const CurveEditor& editor) {
  constexpr int kSteps = 96;
  const TransferCurve curve = editor.curve();
  std::vector<ImVec2> line;
  for (int i = 0; i <= kSteps; ++i) {
    TransferCurve::Point point = editor.point_at({double(i) / kSteps, 0});
    point.alpha = curve.alpha(point.kappa);
    const Vector2d place(double(i) / kSteps, std::clamp(editor.place_of(point).y(), 0.0, 1.0));
    line.push_back(plot.at(place));
  }
  ImDrawList* const list = ImGui::GetWindowDrawList();
  list->AddPolyline(line.data(), int(line.size()), colour(1.0f, 0.82f, 0.42f), 0, em(0.13f));
  for (size_t i = 0; i < editor.points().size(); ++i) {
    const Vector2d place = editor.place_of(editor.points()[i]).cwiseMax(0).cwiseMin(1);
    const bool is_dragged = editor.dragged() == i;
    list->AddCircleFilled(plot.at(place), em(is_dragged ? 0.45f : 0.35f),
                          colour(1.0f, 0.90f, 0.65f));
    list->AddCircle(plot.at(place), em(is_dragged ? 0.45f : 0.35f), colour(0.1f, 0.1f, 0.1f));
  }
}

Vector2d reach(const Plot& plot) {
  return {em(0.8f) / plot.size.x, em(0.8f) / plot.size.y};
}

void handle_mouse(const Plot& plot, Document& document) {
  CurveEditor& editor = document.curve();
  const Vector2d place = plot.place(ImGui::GetIO().MousePos);
  if (ImGui::IsItemHovered() && ImGui::IsMouseClicked(ImGuiMouseButton_Right)) {
    const auto point = editor.point_near(place, reach(plot));
    if (point && editor.remove(*point)) document.commit_curve();
    return;
  }
  if (ImGui::IsItemActivated()) {
    const auto point = editor.point_near(place, reach(plot));
    if (point) {
      editor.begin_drag(*point);
    } else if (editor.add(place)) {
      document.preview_curve();
    }
  }
  if (!editor.dragged()) return;
  if (ImGui::IsItemActive() && ImGui::IsMouseDragging(ImGuiMouseButton_Left, 1)) {
    editor.drag_to(place);
    document.preview_curve();
  }
  if (ImGui::IsItemDeactivated()) {
    if (editor.end_drag()) document.commit_curve();
  }
}

void draw_legend(const CurveEditor& editor) {
  if (const auto dragged = editor.dragged()) {
    const TransferCurve::Point& point = editor.points()[*dragged];
    faint_text("κ %.3g   α %.3g", point.kappa, point.alpha);
    return;
  }
  const double contrast = editor.curve().contrast();
  if (contrast > kCurveContrastWarn) {
    ImGui::TextColored(theme::kBusy, "contrast %.0f: settles slowly", contrast);
    return;
  }
  faint_text("click adds a point, right click removes");
}

}  // namespace

void CurvePanel::draw(Workspace& workspace) {
  Document& document = *workspace.document();
  ImGui::BeginDisabled(document.is_viewer());
  const Plot plot{ImGui::GetCursorScreenPos(), {ImGui::GetContentRegionAvail().x, em(9)}};
  ImGui::InvisibleButton("##plot", plot.size);
  note_place("Plot");
  ImDrawList* const list = ImGui::GetWindowDrawList();
  const ImVec2 high{plot.low.x + plot.size.x, plot.low.y + plot.size.y};
  list->AddRectFilled(plot.low, high, colour(0.09f, 0.10f, 0.11f), em(0.2f));
  const float margin = em(0.5f);  // points on the border are drawn whole
  list->PushClipRect({plot.low.x - margin, plot.low.y - margin}, {high.x + margin, high.y + margin},
                     true);
  draw_histogram(plot, document.scan());
  draw_axes(plot, document.curve().alpha_max());
  handle_mouse(plot, document);
  draw_curve(plot, document.curve());
  list->PopClipRect();
  draw_legend(document.curve());
  ImGui::EndDisabled();
}

}  // namespace burnish
