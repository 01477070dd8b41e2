#include "client/cli/cell_field_file.h"

#include "common/base/text_lines.h"

namespace burnish {

static Result<SetCellFields::Cell> parse_cell(const TextLine& line) {
  if (line.words.size() < 6) return invalid_argument("a line must be: i j k alpha1 alpha2 beta");
  SetCellFields::Cell cell;
  for (int axis = 0; axis < 3; ++axis) {
    ASSIGN_OR_RETURN(cell.cell[axis], parse_integer(line.words[static_cast<size_t>(axis)]));
  }
  ASSIGN_OR_RETURN(cell.alpha1, parse_real(line.words[3]));
  ASSIGN_OR_RETURN(cell.alpha2, parse_real(line.words[4]));
  ASSIGN_OR_RETURN(cell.beta, parse_real(line.words[5]));
  RETURN_IF_ERROR(check_alpha(cell.alpha1).with_context("alpha1"));
  RETURN_IF_ERROR(check_alpha(cell.alpha2).with_context("alpha2"));
  RETURN_IF_ERROR(check_beta(cell.beta));
  return cell;
}

Result<SetCellFields> parse_cell_fields(std::string_view text, const std::string& name) {
  SetCellFields fields;
  for (const TextLine& line : split_lines(text)) {
    const auto cell = parse_cell(line);
    if (!cell.is_ok()) return cell.status().with_context(place(name, line));
    fields.cells.push_back(*cell);
  }
  if (fields.cells.empty()) return invalid_argument(name + " has no cells");
  return fields;
}

Result<SetCellFields> read_cell_field_file(const std::filesystem::path& path) {
  ASSIGN_OR_RETURN(const std::string text, read_text_file(path));
  return parse_cell_fields(text, path.string());
}

}  // namespace burnish
