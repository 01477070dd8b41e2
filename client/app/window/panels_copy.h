#pragma once

#include <cstddef>
#include <vector>

struct ImDrawData;

namespace burnish {

/// A copy of what ImGui drew last, to tell whether it draws the same again.
class PanelsCopy {
 public:
  /// Takes what ImGui draws now. Returns whether it differs from the last.
  bool take(const ImDrawData& drawn);

 private:
  std::vector<std::byte> last_, now_;
};

}  // namespace burnish
