#pragma once

#include <string_view>

namespace burnish {

/// A file as a program carries it (deploy/cmake/carry_files.cmake).
struct CarriedFile {
  std::string_view name;  ///< "index.html", "style.css"
  std::string_view bytes;
};

}  // namespace burnish
