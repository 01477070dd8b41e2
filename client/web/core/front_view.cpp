// Lines about how the session is shown.

#include "client/web/core/front_commands.h"
#include "common/base/text_lines.h"

namespace burnish {

namespace {

Status set_number(const FrontWords& line, double least, double most, double& value) {
  RETURN_IF_ERROR(need_words(line, 1));
  ASSIGN_OR_RETURN(const double number, parse_real(line.words[0]));
  if (!(number >= least && number <= most))
    return invalid_argument(line.command + " " + line.words[0] + " is outside " +
                            std::to_string(least) + " to " + std::to_string(most));
  value = number;
  return Status::ok();
}

Status set_lamp(const FrontWords& line, Lighting& lighting) {
  RETURN_IF_ERROR(need_words(line, 2));
  ASSIGN_OR_RETURN(const std::vector<double> numbers, parse_numbers(line.words, 0));
  lighting = with_lamp_at(lighting, {numbers[0], numbers[1]});
  return Status::ok();
}

Status do_bookmark(const FrontWords& line, Viewport& viewport) {
  RETURN_IF_ERROR(need_words(line, 1));
  if (line.words[0] == "add") {
    viewport.add_bookmark();
    return Status::ok();
  }
  RETURN_IF_ERROR(need_words(line, 2));
  ASSIGN_OR_RETURN(const int number, parse_integer(line.words[1]));
  const auto& bookmarks = viewport.bookmarks;
  if (number < 1 || static_cast<size_t>(number) > bookmarks.size())
    return invalid_argument("bookmark " + line.words[1] + ": there are " +
                            std::to_string(bookmarks.size()));
  viewport.camera = bookmarks[static_cast<size_t>(number) - 1];
  return Status::ok();
}

}  // namespace

std::optional<Status> do_view_line(const FrontWords& line, FrontParts& parts) {
  constexpr double kRangeMin = 0.05, kRangeMax = 20;  // cells
  Viewport& viewport = parts.workspace.viewport;
  ViewOptions& options = viewport.options;
  const std::string& command = line.command;
  if (command == "split_at") return set_number(line, 0, 1, options.split_at);
  if (command == "displacement_range")
    return set_number(line, kRangeMin, kRangeMax, options.displacement_range);
  if (command == "lamp") return set_lamp(line, options.lighting);
  if (command == "bookmark") return do_bookmark(line, viewport);
  if (command == "focus") {
    viewport.focus();
  } else if (command == "frame" && line.words.empty()) {
    viewport.go_home();
  } else {
    return std::nullopt;
  }
  return Status::ok();
}

}  // namespace burnish
