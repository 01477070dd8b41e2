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
    const Eigen::Vector2d at = view_.place(point);
    return {x_of(at.x()), y_of(at.y())};
  }

  // Takes a way and a height, in lengths of the ruler.
  float x_of(double way) const {
    return at_.x + size_.x * static_cast<float>((1 - kPart) / 2 + kPart * way);
  }
  float y_of(double height) const {
    return at_.y + size_.y / 2 - static_cast<float>(kPart * height) * size_.x * exaggeration_;
  }

  std::vector<LengthTick> ways(const std::string& unit) const {
    constexpr double kBeside = (1 - kPart) / kPart / 2;
    return view_.ticks(-kBeside, 1 + kBeside, em(kWayTickEm) / (kPart * size_.x), unit);
  }
  std::vector<LengthTick> heights(const std::string& unit) const {
    const double scale = kPart * size_.x * exaggeration_;
    return view_.ticks(-size_.y / 2 / scale, size_.y / 2 / scale, em(kHeightTickEm) / scale, unit);
  }

 private:
  static constexpr double kPart = 0.9;  // of the window's width for the ruler's way
  static constexpr float kWayTickEm = 5, kHeightTickEm = 2;  // least distance of two numbers

  const SectionView view_;
  const ImVec2 at_, size_;
  const float exaggeration_;
};

/// Draws numbers left of the plot and below it, and faint lines through it.
void draw_numbers(const SectionPlot& plot, const ImVec2& at, const ImVec2& size,
                  const std::string& unit) {
  ImDrawList* const list = ImGui::GetWindowDrawList();
  const ImU32 text = ImGui::ColorConvertFloat4ToU32(theme::kFaint);
  const ImU32 line = ImGui::GetColorU32(ImGuiCol_Border, 0.5f);
  const float bottom = at.y + size.y, right = at.x + size.x, gap = em(0.3f);
  for (const LengthTick& tick : plot.ways(unit)) {
    const float x = plot.x_of(tick.at), width = ImGui::CalcTextSize(tick.text.c_str()).x;
    list->AddLine({x, at.y}, {x, bottom}, line);
    list->AddText({std::min(x - width / 2, right - width), bottom + gap}, text, tick.text.c_str());
  }
  for (const LengthTick& tick : plot.heights(unit)) {
    const float y = plot.y_of(tick.at);
    const ImVec2 words = ImGui::CalcTextSize(tick.text.c_str());
    list->AddLine({at.x, y}, {right, y}, line);
    list->AddText({at.x - gap - words.x, y - words.y / 2}, text, tick.text.c_str());
  }
}

void draw_lines(const SectionPlot& plot, const std::vector<SectionLine>& lines, ImU32 colour) {
  ImDrawList* const list = ImGui::GetWindowDrawList();
  for (const SectionLine& line : lines)
    for (size_t i = 1; i < line.points.size(); ++i)
      list->AddLine(plot.place(line.points[i - 1]), plot.place(line.points[i]), colour, em(0.1f));
}

void draw_plot(const Document& document, float exaggeration) {
  const Measuring& measuring = document.measuring();
  constexpr float kNumbersEm = 5, kNumbersBelowEm = 1.6f;
  const ImVec2 whole = ImGui::GetContentRegionAvail(), corner = ImGui::GetCursorScreenPos();
  const ImVec2 at{corner.x + em(kNumbersEm), corner.y};
  const ImVec2 size{whole.x - em(kNumbersEm), whole.y - em(kNumbersBelowEm)};
  ImGui::InvisibleButton("##plot", {std::max(whole.x, 1.0f), std::max(whole.y, 1.0f)});
  if (size.x < 1 || size.y < 1) return;
  if (measuring.ruler.ends().size() < 2 || !measuring.section()) return;
  ImDrawList* const list = ImGui::GetWindowDrawList();
  const SectionPlot plot(SectionView(*measuring.plane(), measuring.ruler), at, size, exaggeration);
  draw_numbers(plot, at, size, document.unit());
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
