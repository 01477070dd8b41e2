#include "client/report/section_file.h"

#include <algorithm>
#include <cstdio>

#include "client/report/length_ticks.h"
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

std::string printed(const char* format, double first, double second, double third) {
  char text[128];
  std::snprintf(text, sizeof text, format, first, second, third);
  return text;
}

/// Draws lines into a box of the width kWidth; the y axis of SVG goes down.
class Drawing {
 public:
  explicit Drawing(const Box& box) : box_(box) {
    const double widest = std::max(box.sizes().x(), box.sizes().y());
    scale_ = widest > 0 ? kWidth / widest : 1;
  }

  double width() const { return right() + kMargin; }
  double height() const { return bottom() + kNumbersBelow; }

  std::string lines(const std::vector<SectionLine>& lines, const char* colour) const {
    std::string text;
    for (const SectionLine& line : lines) {
      text += "<polyline fill=\"none\" stroke-width=\"1\" stroke=\"";
      text += std::string(colour) + "\" points=\"";
      for (const Eigen::Vector2d& point : line.points)
        text += printed("%.3f,%.3f ", x_of(point.x()), y_of(point.y()), 0);
      text += "\"/>\n";
    }
    return text;
  }

  /// Numbers below the lines and left of them, as the table of the section has them.
  std::string axes(const std::string& unit) const {
    std::string path, numbers;
    for (const LengthTick& tick : ticks(0, kWayTick, unit)) {
      path += printed("M%.2f %.2fV%.2f", x_of(tick.at), kMargin, bottom());
      numbers += number("middle", x_of(tick.at), bottom() + kLetters + kGap, tick);
    }
    for (const LengthTick& tick : ticks(1, kHeightTick, unit)) {
      path += printed("M%.2f %.2fH%.2f", kNumbersBeside, y_of(tick.at), right());
      numbers += number("end", kNumbersBeside - kGap, y_of(tick.at) + kLetters / 3, tick);
    }
    return "<path d=\"" + path + "\" stroke=\"#ddd\"/>\n" + numbers;
  }

 private:
  static constexpr double kWidth = 1000, kMargin = 20;
  static constexpr double kNumbersBeside = 80, kNumbersBelow = 40;
  static constexpr double kWayTick = 80, kHeightTick = 30;  // least distance of two numbers
  static constexpr double kLetters = 14, kGap = 6;

  double x_of(double right) const { return kNumbersBeside + (right - box_.min().x()) * scale_; }
  double y_of(double up) const { return kMargin + (box_.max().y() - up) * scale_; }
  double right() const { return x_of(box_.max().x()); }
  double bottom() const { return y_of(box_.min().y()); }

  std::vector<LengthTick> ticks(int axis, double apart, const std::string& unit) const {
    return length_ticks(box_.min()[axis], box_.max()[axis], apart / scale_, unit);
  }

  static std::string number(const char* anchor, double x, double y, const LengthTick& tick) {
    return printed("<text x=\"%.1f\" y=\"%.1f\" font-size=\"%.0f\" text-anchor=\"", x, y,
                   kLetters) +
           anchor + "\">" + tick.text + "</text>\n";
  }

  const Box box_;
  double scale_;
};

std::string escaped_unit(const std::string& unit) {
  std::string safe;
  for (const char c : unit) safe += c == '<' || c == '&' || c == '>' ? '?' : c;
  return safe;
}

}  // namespace

std::string section_svg(const Section& section, const std::string& unit) {
  const Drawing drawing(box_of(section));
  return printed("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 %.0f %.0f\">\n",
                 drawing.width(), drawing.height(), 0) +
         "<title>Section: original grey, edited red</title>\n" + drawing.axes(escaped_unit(unit)) +
         drawing.lines(section.original, "#888") + drawing.lines(section.edited, "#b33") +
         "</svg>\n";
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
