#include "common/archive/entry_name.h"

#include <algorithm>
#include <cctype>

#include "common/base/limits.h"
#include "common/base/text.h"

namespace burnish {

std::string shown_entry(std::string_view name) {
  constexpr size_t kShownBytesMax = 100;
  return "'" + one_line(name, kShownBytesMax) + "'";
}

std::string plain_entry_name(std::string_view name, bool is_of_windows) {
  std::string written(name);
  if (is_of_windows) std::replace(written.begin(), written.end(), '\\', '/');
  std::string plain;
  for (size_t begin = 0; begin < written.size();) {
    const size_t end = std::min(written.find('/', begin), written.size() - 1) + 1;
    const std::string_view part = std::string_view(written).substr(begin, end - begin);
    if (part != kArchiveRoot) plain += part;
    begin = end;
  }
  return plain.empty() && !written.empty() ? std::string(kArchiveRoot) : plain;
}

static Status refused_name(std::string_view name, const std::string& why) {
  return invalid_argument("entry " + shown_entry(name) + " " + why);
}

static bool controls(char c) {
  return static_cast<unsigned char>(c) < 0x20 || c == 0x7f;
}

static bool has_drive(std::string_view name) {
  return name.size() >= 2 && name[1] == ':' && std::isalpha(static_cast<unsigned char>(name[0]));
}

static Status check_part(std::string_view name, std::string_view part) {
  if (part.empty()) return refused_name(name, "has an empty part between two '/'");
  if (part == "." || part == "..")
    return refused_name(name, "has the part '" + std::string(part) + "', which leads elsewhere");
  return Status::ok();
}

Status check_entry_name(std::string_view name) {
  if (name.empty()) return invalid_argument("an entry has no name");
  if (name.size() > kArchiveNameBytesMax)
    return refused_name(name, "has a name of " + std::to_string(name.size()) +
                                  " bytes, the limit is " + std::to_string(kArchiveNameBytesMax));
  if (name.front() == '/') return refused_name(name, "is an absolute path");
  if (has_drive(name)) return refused_name(name, "names a drive");
  if (name.find('\\') != std::string_view::npos)
    return refused_name(
        name, "has a '\\' between its parts; pack the folder with a program that writes '/'");
  if (std::any_of(name.begin(), name.end(), controls))
    return refused_name(name, "has a control character in its name");
  std::string_view rest = name.ends_with('/') ? name.substr(0, name.size() - 1) : name;
  for (size_t end; (end = rest.find('/')) != std::string_view::npos; rest.remove_prefix(end + 1))
    RETURN_IF_ERROR(check_part(name, rest.substr(0, end)));
  return check_part(name, rest);
}

}  // namespace burnish
