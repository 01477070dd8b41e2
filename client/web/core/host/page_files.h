#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace burnish {

/// A file that the user has given to the page.
struct PageFile {
  int handle = 0;  ///< of the worker
  uint64_t size_bytes = 0;
};

/// Remembers a file by its name. A later one of the same name takes its place.
void add_page_file(const std::string& name, const PageFile& file);
std::optional<PageFile> find_page_file(const std::string& name);

/// Reads at most `bytes` from `offset` on. Returns fewer at the end, or if the file has changed.
std::string read_page_file(const PageFile& file, uint64_t offset, size_t bytes);

}  // namespace burnish
