#pragma once

#include <string>
#include <vector>

namespace burnish {

/// Warns on stderr that attributes of a scan's file are not in another one. Says nothing of none.
void warn_of_left_out(const std::vector<std::string>& names, const std::string& file);

}  // namespace burnish
