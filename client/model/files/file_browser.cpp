#include "client/model/files/file_browser.h"

#include <algorithm>

#include "client/model/files/typed_path.h"

namespace burnish {

namespace fs = std::filesystem;

static bool is_folder(const fs::path& path) {
  std::error_code ignored;
  return fs::is_directory(path, ignored);
}

static bool is_there(const fs::path& path) {
  std::error_code ignored;
  return fs::exists(path, ignored);
}

static bool is_path(const std::string& typed) {
  return typed.starts_with('/') || typed.starts_with('~');
}

FileBrowser::FileBrowser(FileQuestion question) : question_(std::move(question)) {
  const bool names_a_file = saves() && !is_folder(question_.start);
  const fs::path folder = names_a_file ? question_.start.parent_path() : question_.start;
  go(is_folder(folder) ? folder : typed_path("~"));
  if (names_a_file) typed_ = question_.start.filename().string();
}

void FileBrowser::type(const std::string& text) {
  if (typed_ == text) return;
  typed_ = text;
  chosen_.clear();
  problem_.clear();
  replaces_ = false;
}

std::vector<ListedFile> FileBrowser::shown() const {
  if (saves() || is_path(typed_)) return files_;
  std::vector<ListedFile> shown;
  std::copy_if(files_.begin(), files_.end(), std::back_inserter(shown),
               [this](const ListedFile& file) { return has_text(file.name, typed_); });
  return shown;
}

void FileBrowser::choose(const ListedFile& file) {
  if (saves() && !file.is_folder) type(file.name);
  chosen_ = file.name;
}

void FileBrowser::move(int by) {
  const std::vector<ListedFile> files = shown();
  if (files.empty()) return;
  const auto at = std::find_if(files.begin(), files.end(),
                               [this](const ListedFile& each) { return each.name == chosen_; });
  const auto last = static_cast<std::ptrdiff_t>(files.size()) - 1;
  const std::ptrdiff_t from = at == files.end() ? (by > 0 ? -1 : last + 1) : at - files.begin();
  choose(files[static_cast<size_t>(std::clamp<std::ptrdiff_t>(from + by, 0, last))]);
}

void FileBrowser::go(const fs::path& folder) {
  const auto files = list_folder(folder, question_.extensions);
  problem_ = files.is_ok() ? "" : files.status().message();
  if (!files.is_ok()) return;
  folder_ = folder;
  files_ = *files;
  chosen_.clear();
  if (!saves()) typed_.clear();
  replaces_ = false;
}

std::optional<fs::path> FileBrowser::enter() {
  if (is_path(typed_)) return enter_path(typed_path(typed_));
  return saves() ? enter_path(folder_ / typed_) : enter_entry();
}

std::optional<fs::path> FileBrowser::enter_path(const fs::path& path) {
  if (is_folder(path)) {
    if (saves()) typed_.clear();
    go(path);
    return std::nullopt;
  }
  if (saves()) return save_as(path);
  if (is_there(path)) return path;
  problem_ = path.string() + " is not there";
  return std::nullopt;
}

std::optional<fs::path> FileBrowser::enter_entry() {
  for (const ListedFile& file : shown()) {
    if (!chosen_.empty() && file.name != chosen_) continue;
    if (!file.is_folder) return folder_ / file.name;
    go(folder_ / file.name);
    return std::nullopt;
  }
  problem_ = "no file here has '" + typed_ + "' in its name";
  return std::nullopt;
}

std::optional<fs::path> FileBrowser::save_as(fs::path path) {
  if (path.extension().empty() && !question_.extensions.empty()) path += question_.extensions[0];
  if (!is_folder(path.parent_path())) {
    problem_ = path.parent_path().string() + " is not there";
    return std::nullopt;
  }
  if (!std::exchange(replaces_, true) && is_there(path)) return std::nullopt;
  replaces_ = false;
  return path;
}

}  // namespace burnish
