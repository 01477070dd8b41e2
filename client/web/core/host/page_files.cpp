#include "client/web/core/host/page_files.h"

#include <map>

#include "client/web/core/host/imports.h"

namespace burnish {

static std::map<std::string, PageFile>& page_files() {
  static auto* const the = new std::map<std::string, PageFile>();  // lives as long as the page
  return *the;
}

void add_page_file(const std::string& name, const PageFile& file) {
  page_files()[name] = file;
}

std::optional<PageFile> find_page_file(const std::string& name) {
  const auto found = page_files().find(name);
  return found == page_files().end() ? std::nullopt : std::optional(found->second);
}

std::string read_page_file(const PageFile& file, uint64_t offset, size_t bytes) {
  std::string read(bytes, '\0');
  read.resize(host_file_read(file.handle, static_cast<double>(offset),
                             reinterpret_cast<uint8_t*>(read.data()), bytes));
  return read;
}

}  // namespace burnish
