#include "client/report/section_file.h"

#include <cmath>
#include <cstdio>

#include "client/report/length_text.h"
#include "common/base/atomic_file.h"

namespace burnish {

namespace {

using Box = Eigen::AlignedBox2d;

Box box_of(const Section& section) {
  Box box;
  for (const auto* lines : {&section.original, &section.edited})
    for (const SectionLine& line : *lines)
      for (const Eigen::Vector2d& point : line.points) box.extend(point);
  if (box.isEmpty()) box.extend(Eigen::Vector2d(0, 0));
  return box;
}

/// Draws lines into a box of the width kWidth; the y axis of SVG goes down.
class Drawing {
 public:
  static constexpr double kWidth = 1000, kMargin = 20;

  explicit Drawing(const Box& box) : box_(box) {
    const double widest = std::max(box.sizes().x(), box.sizes().y());
    scale_ = widest > 0 ? kWidth / widest : 1;
  }

  double scale() const { return scale_; }
  double width() const { return box_.sizes().x() * scale_ + 2 * kMargin; }
  double height() const { return box_.sizes().y() * scale_ + 4 * kMargin; }

  std::string lines(const std::vector<SectionLine>& lines, const char* colour) const {
    std::string text;
    for (const SectionLine& line : lines) {
      text += "<polyline fill=\"none\" stroke-width=\"1\" stroke=\"";
      text += std::string(colour) + "\" points=\"";
      for (const Eigen::Vector2d& point : line.points) text += place(point);
      text += "\"/>\n";
    }
    return text;
  }

 private:
  std::string place(const Eigen::Vector2d& point) const {
    char text[64];
    std::snprintf(text, sizeof text, "%.3f,%.3f ", kMargin + (point.x() - box_.min().x()) * scale_,
                  kMargin + (box_.max().y() - point.y()) * scale_);
    return text;
  }

  const Box box_;
  double scale_;
};

/// The largest power of ten that is not above a positive, finite length.
double decade_of(double length) {
  double tens = 1;
  if (length < 1) {
    while (1 / tens > length) tens *= 10;
    return 1 / tens;
  }
  while (10 * tens <= length) tens *= 10;
  return tens;
}

/// A round length of about a fifth of the drawing's width.
double scale_bar_length(double length) {
  if (!(length > 0) || !std::isfinite(length)) return 1;
  const double decade = decade_of(length / 5);
  for (const double step : {5.0, 2.0})
    if (step * decade <= length / 5) return step * decade;
  return decade;
}

std::string escaped_unit(const std::string& unit) {
  std::string safe;
  for (const char c : unit) safe += c == '<' || c == '&' || c == '>' ? '?' : c;
  return safe;
}

}  // namespace

std::string section_svg(const Section& section, const std::string& unit) {
  const Drawing drawing(box_of(section));
  const double bar = scale_bar_length(Drawing::kWidth / drawing.scale());
  const double below = drawing.height() - Drawing::kMargin;
  char head[256], foot[512];
  std::snprintf(head, sizeof head,
                "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 %.0f %.0f\">\n"
                "<title>Section: original grey, edited red</title>\n",
                drawing.width(), drawing.height());
  std::snprintf(foot, sizeof foot,
                "<path d=\"M%.0f %.1f h%.3f\" stroke=\"#222\" stroke-width=\"2\"/>\n"
                "<text x=\"%.0f\" y=\"%.1f\" font-size=\"14\">%s</text>\n</svg>\n",
                Drawing::kMargin, below, bar * drawing.scale(), Drawing::kMargin, below - 6,
                length_text(bar, escaped_unit(unit)).c_str());
  return head + drawing.lines(section.original, "#888") + drawing.lines(section.edited, "#b33") +
         foot;
}

static void add_rows(const char* surface, const std::vector<SectionLine>& lines,
                     std::string& text) {
  for (size_t i = 0; i < lines.size(); ++i)
    for (const Eigen::Vector2d& point : lines[i].points) {
      char row[96];
      std::snprintf(row, sizeof row, "%s,%zu,%.9g,%.9g\n", surface, i, point.x(), point.y());
      text += row;
    }
}

std::string section_csv(const Section& section) {
  std::string text = "surface,line,right,up\n";
  add_rows("original", section.original, text);
  add_rows("edited", section.edited, text);
  return text;
}

Status check_section_name(const std::filesystem::path& file) {
  const std::string ending = file.extension().string();
  if (ending == ".svg" || ending == ".csv") return Status::ok();
  return invalid_argument("a section is written to .svg or .csv, not to " +
                          file.filename().string());
}

Status write_section(const Section& section, const std::string& unit,
                     const std::filesystem::path& file) {
  const bool is_table = file.extension() == ".csv";
  return write_file(file, is_table ? section_csv(section) : section_svg(section, unit));
}

}  // namespace burnish
