#include "client/cli/warn_of_left_out.h"

#include <iostream>

#include "common/mesh/rewrite/left_out/left_out.h"

namespace burnish {

void warn_of_left_out(const std::vector<std::string>& names, const std::string& file) {
  if (names.empty()) return;
  std::cerr << "warning: not in " << file << ": " << left_out_text(names)
            << "; the scan's own format keeps all\n";
}

}  // namespace burnish
