#include "client/model/files/file_list.h"

#include <algorithm>
#include <cctype>

#include <sys/stat.h>

#include "client/tools/user_folders.h"

namespace burnish {

namespace fs = std::filesystem;

static std::string lower(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

static bool has_extension(const fs::path& path, const std::vector<std::string>& extensions) {
  const std::string extension = lower(path.extension().string());
  return extensions.empty() ||
         std::find(extensions.begin(), extensions.end(), extension) != extensions.end();
}

static bool comes_before(const ListedFile& a, const ListedFile& b) {
  if (a.is_folder != b.is_folder) return a.is_folder;
  const std::string lower_a = lower(a.name), lower_b = lower(b.name);
  return lower_a != lower_b ? lower_a < lower_b : a.name < b.name;
}

// Follows links. A file that nobody can look at is no entry.
static bool look_at(const fs::path& path, ListedFile& file) {
  struct stat found = {};
  if (stat(path.c_str(), &found) != 0) return false;
  file.name = path.filename().string();
  file.is_folder = S_ISDIR(found.st_mode);
  file.size_bytes = file.is_folder ? 0 : static_cast<uint64_t>(found.st_size);
  file.changed_unix_seconds = found.st_mtime;
  return file.is_folder || S_ISREG(found.st_mode);
}

Result<std::vector<ListedFile>> list_folder(const fs::path& folder,
                                            const std::vector<std::string>& extensions) {
  std::error_code error;
  fs::directory_iterator entry(folder, error);
  std::vector<ListedFile> files;
  for (; !error && entry != fs::directory_iterator(); entry.increment(error)) {
    ListedFile file;
    if (entry->path().filename().native().starts_with('.') || !look_at(entry->path(), file))
      continue;
    if (file.is_folder || has_extension(entry->path(), extensions)) files.push_back(file);
  }
  if (error) return errno_status("cannot list " + folder.string(), error.value());
  std::sort(files.begin(), files.end(), comes_before);
  if (files.size() > kFilesListedMax) files.resize(kFilesListedMax);
  return files;
}

bool has_text(const std::string& name, const std::string& typed) {
  return lower(name).find(lower(typed)) != std::string::npos;
}

std::vector<Place> places_to_look(const std::vector<fs::path>& recent) {
  std::vector<Place> places;
  std::error_code ignored;
  const auto add = [&](const std::string& name, const fs::path& folder) {
    const bool is_known = std::any_of(places.begin(), places.end(),
                                      [&](const Place& each) { return each.folder == folder; });
    if (!is_known && fs::is_directory(folder, ignored)) places.push_back({name, folder});
  };
  if (const fs::path home = home_folder(); !home.empty()) {
    add("Home", home);
    for (const char* const below : {"Desktop", "Documents", "Downloads"}) add(below, home / below);
  }
  for (const fs::path& folder : recent) add(folder.filename().string(), folder);
  add("Computer", "/");
  return places;
}

}  // namespace burnish
