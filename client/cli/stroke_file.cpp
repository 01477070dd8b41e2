#include "client/cli/stroke_file.h"

#include <span>

#include "common/base/text_lines.h"

namespace burnish {

static Result<Stroke> parse_brush(const TextLine& line) {
  if (line.words.size() < 5)
    return invalid_argument(
        "a brush line must be: brush RADIUS STRENGTH BETA FALLOFF [WHAT] [through]");
  Stroke stroke;
  ASSIGN_OR_RETURN(stroke.brush.radius, parse_real(line.words[1]));
  ASSIGN_OR_RETURN(stroke.brush.strength, parse_real(line.words[2]));
  ASSIGN_OR_RETURN(stroke.brush.beta, parse_real(line.words[3]));
  ASSIGN_OR_RETURN(stroke.brush.fall_off, parse_fall_off(line.words[4]));
  RETURN_IF_ERROR(parse_brush_words(std::span(line.words).subspan(5), stroke.brush));
  return stroke;
}

static Result<Vec3d> parse_point(const TextLine& line) {
  if (line.words.size() != 3) return invalid_argument("a point of a path must be: X Y Z");
  Vec3d point;
  for (int axis = 0; axis < 3; ++axis) {
    ASSIGN_OR_RETURN(point[axis], parse_real(line.words[static_cast<size_t>(axis)]));
  }
  return point;
}

static Status parse_line(const TextLine& line, std::vector<Stroke>& strokes) {
  if (line.words[0] == "brush") {
    ASSIGN_OR_RETURN(Stroke stroke, parse_brush(line));
    strokes.push_back(std::move(stroke));
    return Status::ok();
  }
  if (strokes.empty()) return invalid_argument("a brush line must come before the first point");
  ASSIGN_OR_RETURN(const Vec3d point, parse_point(line));
  strokes.back().path.push_back(point);
  return Status::ok();
}

Result<std::vector<Stroke>> parse_strokes(std::string_view text, const std::string& name) {
  std::vector<Stroke> strokes;
  std::string begin;  // place where the current stroke began
  const auto check_last = [&] {
    return strokes.empty() ? Status::ok() : validate(strokes.back()).with_context(begin);
  };
  for (const TextLine& line : split_lines(text)) {
    if (line.words[0] == "brush") {
      RETURN_IF_ERROR(check_last());
      begin = place(name, line);
    }
    RETURN_IF_ERROR(parse_line(line, strokes).with_context(place(name, line)));
  }
  RETURN_IF_ERROR(check_last());
  if (strokes.empty()) return invalid_argument(name + " has no strokes");
  return strokes;
}

Result<std::vector<Stroke>> read_stroke_file(const std::filesystem::path& path) {
  ASSIGN_OR_RETURN(const std::string text, read_text_file(path));
  return parse_strokes(text, path.string());
}

}  // namespace burnish
