#include "client/app/section_window.h"

#include <algorithm>
#include <cmath>

#include "client/app/places.h"
#include "client/app/theme.h"
#include "client/report/length_text.h"
#include "client/report/section_file.h"

namespace burnish {

Plane section_plane(const Ruler& ruler, const Camera& camera) {
  const Vec3d along = ruler.ends()[1].edited - ruler.ends()[0].edited;
  const Eigen::Matrix3d axes = camera_axes(camera);
  const Vec3d back = axes.row(2), up = axes.row(1);
  const Vec3d across = along.cross(back);
  // A ruler that runs along the view is cut upright.
  const Vec3d normal = across.norm() > 1e-9 * along.norm() ? across : Vec3d(along.cross(up));
  return {ruler.ends()[0].edited, normal.stableNormalized()};
}

namespace {

/// Turns the plane so that the ruler lies level, and scales its way to the window's width.
class SectionView {
 public:
  SectionView(const Plane& plane, const Ruler& ruler, const ImVec2& at, const ImVec2& size,
              float exaggeration)
      : at_(at), size_(size), exaggeration_(exaggeration) {
    const PlaneAxes axes = axes_of(plane);
    const Vec3d way = ruler.ends()[1].edited - plane.point;
    const Eigen::Vector2d level(axes.right.dot(way), axes.up.dot(way));
    length_ = std::max(level.norm(), 1e-300);
    turn_ = level / length_;
  }

  ImVec2 place(const Eigen::Vector2d& point) const {
    const double along = turn_.dot(point), height = turn_.x() * point.y() - turn_.y() * point.x();
    const double scale = kPart * size_.x / length_;
    return {
        at_.x + size_.x * static_cast<float>((1 - kPart) / 2) + static_cast<float>(along * scale),
        at_.y + size_.y / 2 - static_cast<float>(height * scale) * exaggeration_};
  }

  double length() const { return length_; }

 private:
  static constexpr double kPart = 0.9;  // of the window's width for the ruler's way

  const ImVec2 at_, size_;
  const float exaggeration_;
  double length_;
  Eigen::Vector2d turn_;
};

void draw_lines(const SectionView& view, const std::vector<SectionLine>& lines, ImU32 colour) {
  ImDrawList* const list = ImGui::GetWindowDrawList();
  for (const SectionLine& line : lines)
    for (size_t i = 1; i < line.points.size(); ++i)
      list->AddLine(view.place(line.points[i - 1]), view.place(line.points[i]), colour, em(0.1f));
}

void draw_plot(const Document& document, float exaggeration) {
  const Measuring& measuring = document.measuring();
  const ImVec2 at = ImGui::GetCursorScreenPos(), size = ImGui::GetContentRegionAvail();
  ImGui::InvisibleButton("##plot", {std::max(size.x, 1.0f), std::max(size.y, 1.0f)});
  if (measuring.ruler.ends().size() < 2 || !measuring.section()) return;
  ImDrawList* const list = ImGui::GetWindowDrawList();
  const SectionView view(*measuring.plane(), measuring.ruler, at, size, exaggeration);
  list->PushClipRect(at, {at.x + size.x, at.y + size.y}, true);
  draw_lines(view, measuring.section()->original, ImGui::ColorConvertFloat4ToU32(theme::kFaint));
  draw_lines(view, measuring.section()->edited, ImGui::ColorConvertFloat4ToU32(theme::kBad));
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
    faint_text("ruler %s", length_text(*length, document.unit()).c_str());
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
