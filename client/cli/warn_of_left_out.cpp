#include "client/cli/warn_of_left_out.h"

#include <algorithm>
#include <iostream>

#include "common/mesh/rewrite/left_out/left_out.h"

namespace burnish {

void warn_of_left_out(const std::vector<std::string>& names, const std::string& file) {
  if (names.empty()) return;
  std::cerr << "warning: not in " << file << ": " << left_out_text(names);
  if (std::ranges::none_of(names, is_lost_in_any_format))
    std::cerr << "; the scan's own format keeps all";
  std::cerr << '\n';
}

}  // namespace burnish
