#include "client/app/overlay/section_window.h"

#include <algorithm>

#include "client/app/widgets/places.h"
#include "client/app/widgets/theme.h"
#include "client/model/view/section_view.h"
#include "client/report/length_text.h"
#include "client/report/section_file.h"

namespace burnish {

namespace {

/// Scales the ruler's way to the window's width.
class SectionPlot {
 public:
  SectionPlot(const SectionView& view, const ImVec2& at, const ImVec2& size, float exaggeration)
      : view_(view), at_(at), size_(size), exaggeration_(exaggeration) {}

  ImVec2 place(const Eigen::Vector2d& point) const {
    const Eigen::Vector2f at = (kPart * size_.x * view_.place(point)).cast<float>();
    return {at_.x + size_.x * static_cast<float>((1 - kPart) / 2) + at.x(),
            at_.y + size_.y / 2 - at.y() * exaggeration_};
  }

 private:
  static constexpr double kPart = 0.9;  // of the window's width for the ruler's way

  const SectionView view_;
  const ImVec2 at_, size_;
  const float exaggeration_;
};

void draw_lines(const SectionPlot& plot, const std::vector<SectionLine>& lines, ImU32 colour) {
  ImDrawList* const list = ImGui::GetWindowDrawList();
  for (const SectionLine& line : lines)
    for (size_t i = 1; i < line.points.size(); ++i)
      list->AddLine(plot.place(line.points[i - 1]), plot.place(line.points[i]), colour, em(0.1f));
}

void draw_plot(const Document& document, float exaggeration) {
  const Measuring& measuring = document.measuring();
  const ImVec2 at = ImGui::GetCursorScreenPos(), size = ImGui::GetContentRegionAvail();
  ImGui::InvisibleButton("##plot", {std::max(size.x, 1.0f), std::max(size.y, 1.0f)});
  if (measuring.ruler.ends().size() < 2 || !measuring.section()) return;
  ImDrawList* const list = ImGui::GetWindowDrawList();
  const SectionPlot plot(SectionView(*measuring.plane(), measuring.ruler), at, size, exaggeration);
  list->PushClipRect(at, {at.x + size.x, at.y + size.y}, true);
  draw_lines(plot, measuring.section()->original, ImGui::ColorConvertFloat4ToU32(theme::kFaint));
  draw_lines(plot, measuring.section()->edited, ImGui::ColorConvertFloat4ToU32(theme::kBad));
  list->PopClipRect();
}

}  // namespace

void SectionWindow::save(const std::string& ending, Workspace& workspace) {
  const Document& document = *workspace.document();
  std::error_code ignored;
  const auto file =
      std::filesystem::absolute(document.scan().scan.name + "-section" + ending, ignored);
  const Status written = write_section(*document.measuring().section(), document.unit(), file);
  if (!written.is_ok()) return workspace.log.failure("section", written);
  workspace.log.info("saved " + file.string());
}

void SectionWindow::draw_controls(Workspace& workspace) {
  const Document& document = *workspace.document();
  ImGui::SetNextItemWidth(em(9));
  ImGui::SliderFloat("##exaggeration", &exaggeration_, 1, 50, "heights × %.1f",
                     ImGuiSliderFlags_Logarithmic);
  hint("Draws heights larger than ways.");
  ImGui::BeginDisabled(!document.measuring().section());
  ImGui::SameLine();
  if (ImGui::Button("Save drawing")) save(".svg", workspace);
  ImGui::SameLine();
  if (ImGui::Button("Save table")) save(".csv", workspace);
  ImGui::EndDisabled();
  ImGui::SameLine();
  ImGui::TextColored(theme::kFaint, "original");
  ImGui::SameLine();
  ImGui::TextColored(theme::kBad, "edited");
  if (const auto length = document.measuring().ruler.length()) {
    ImGui::SameLine();
    faint_text("ruler %s", length_text(*length, document.unit(), kRulerDigits).c_str());
  }
}

void SectionWindow::draw(Workspace& workspace) {
  Document& document = *workspace.document();
  covered_low = covered_high = {0, 0};
  if (!document.measuring().plane()) return;
  document.measuring().follow_section(document.shown());
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowSize({em(40), em(18)}, ImGuiCond_FirstUseEver);
  ImGui::SetNextWindowPos({screen.x / 2, screen.y - em(1)}, ImGuiCond_FirstUseEver, {0.5f, 1});
  bool is_open = true;
  if (ImGui::Begin("Section", &is_open, ImGuiWindowFlags_NoSavedSettings)) {
    draw_controls(workspace);
    draw_plot(document, exaggeration_);
  }
  covered_low = ImGui::GetWindowPos();
  covered_high = {covered_low.x + ImGui::GetWindowWidth(),
                  covered_low.y + ImGui::GetWindowHeight()};
  note_window("Section");
  ImGui::End();
  if (!is_open) document.measuring().forget_section();
}

}  // namespace burnish
