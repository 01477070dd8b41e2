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

Status turn(const FrontWords& line, Viewport& viewport) {
  RETURN_IF_ERROR(need_words(line, 2));
  ASSIGN_OR_RETURN(const std::vector<double> degrees, parse_numbers(line.words, 0));
  viewport.turn(degrees[0], degrees[1]);
  return Status::ok();
}

}  // namespace

std::optional<Status> do_view_line(const FrontWords& line, FrontParts& parts) {
  Viewport& viewport = parts.workspace.viewport;
  ViewOptions& options = viewport.options;
  const std::string& command = line.command;
  if (command == "split_at") return set_number(line, 0, 1, options.split_at);
  if (command == "turn") return turn(line, viewport);
  if (command == "lamp") return set_lamp(line, options.lighting);
  if (command == "bookmark") {
    viewport.add_bookmark();
  } else if (command == "menu") {
    viewport.menu.reset();
  } else if (command == "focus") {
    viewport.focus();
  } else if (command == "frame" && line.words.empty()) {
    viewport.go_home();
  } else {
    return std::nullopt;
  }
  return Status::ok();
}

}  // namespace burnish
