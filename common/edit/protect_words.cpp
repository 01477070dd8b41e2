#include "common/edit/protect_words.h"

#include <algorithm>

#include "common/base/line_text.h"
#include "common/base/text_lines.h"

namespace burnish {
namespace {

Result<std::vector<double>> numbers_of(const std::vector<std::string>& words, size_t first) {
  std::vector<double> numbers;
  for (size_t i = first; i < words.size(); ++i) {
    ASSIGN_OR_RETURN(const double number, parse_real(words[i]));
    numbers.push_back(number);
  }
  return numbers;
}

Status check_count(const std::string& word, size_t count, size_t wanted) {
  if (count == wanted) return Status::ok();
  return invalid_argument("'" + word + "' has " + std::to_string(count) + " numbers, not " +
                          std::to_string(wanted));
}

Result<LassoRegion> parse_lasso(const std::string& word, const std::vector<double>& numbers) {
  LassoRegion lasso;
  const size_t view = lasso.view_projection.size();
  if (numbers.size() < view || (numbers.size() - view) % 2 != 0)
    return invalid_argument("'" + word + "' has " + std::to_string(numbers.size()) +
                            " numbers, not 16 and two for each point");
  std::copy_n(numbers.begin(), view, lasso.view_projection.begin());
  for (size_t i = view; i < numbers.size(); i += 2)
    lasso.polygon.emplace_back(numbers[i], numbers[i + 1]);
  lasso.through = word == "through";
  return lasso;
}

Result<Protect> parse_way(const std::vector<std::string>& words) {
  const std::string word = words.empty() ? "" : words[0];
  ASSIGN_OR_RETURN(const std::vector<double> numbers,
                   numbers_of(words, std::min<size_t>(1, words.size())));
  if (word == "lasso" || word == "through") {
    ASSIGN_OR_RETURN(LassoRegion lasso, parse_lasso(word, numbers));
    return Protect{std::move(lasso)};
  }
  if (word == "curvature") {
    RETURN_IF_ERROR(check_count(word, numbers.size(), 2));
    return Protect{CurvatureRegion{numbers[0], numbers[1]}};
  }
  if (word == "piece") {
    RETURN_IF_ERROR(check_count(word, numbers.size(), 3));
    return Protect{PieceRegion{Vec3d(numbers[0], numbers[1], numbers[2])}};
  }
  if (word == "grow" || word == "shrink") {
    RETURN_IF_ERROR(check_count(word, numbers.size(), 1));
    ASSIGN_OR_RETURN(const int cells, parse_integer(words[1]));
    return Protect{GrownRegion{word == "grow" ? cells : -cells}};
  }
  if (word == "invert" || word == "clear") {
    RETURN_IF_ERROR(check_count(word, numbers.size(), 0));
    if (word == "invert") return Protect{InvertedRegion{}};
    return Protect{NoRegion{}};
  }
  return invalid_argument(
      "'" + word + "' is not lasso, through, curvature, piece, grow, shrink, invert or clear");
}

struct WordsOf {
  LineText& line;

  void operator()(const LassoRegion& lasso) const {
    line << (lasso.through ? "through" : "lasso");
    for (const double x : lasso.view_projection) line << ' ' << x;
    for (const Eigen::Vector2d& point : lasso.polygon) line << ' ' << point.x() << ' ' << point.y();
  }
  void operator()(const CurvatureRegion& region) const {
    line << "curvature " << region.least << ' ' << region.most;
  }
  void operator()(const PieceRegion& region) const {
    line << "piece " << region.point.x() << ' ' << region.point.y() << ' ' << region.point.z();
  }
  void operator()(const GrownRegion& region) const {
    line << (region.cells > 0 ? "grow " : "shrink ") << std::abs(region.cells);
  }
  void operator()(const InvertedRegion&) const { line << "invert"; }
  void operator()(const NoRegion&) const { line << "clear"; }
};

}  // namespace

Result<Protect> parse_protect(const std::vector<std::string>& words) {
  const bool releases = !words.empty() && words[0] == "release";
  ASSIGN_OR_RETURN(Protect change, parse_way({words.begin() + (releases ? 1 : 0), words.end()}));
  change.release = releases;
  RETURN_IF_ERROR(validate(change));
  return change;
}

std::string to_words(const Protect& change) {
  LineText line(LineText::kExact);
  if (change.release) line << "release ";
  std::visit(WordsOf{line}, change.way);
  return line.text();
}

}  // namespace burnish
