#include "client/app/widgets/depth_list.h"

#include <imgui.h>

#include "client/app/widgets/places.h"
#include "common/base/check.h"

namespace burnish {

static std::string label_of(const DepthChoice& choice) {
  if (!choice.refusal.empty())
    return "depth " + std::to_string(choice.depth) + ": " + choice.refusal;
  return choice.is_default ? choice.text + " (default)" : choice.text;
}

std::optional<int> draw_depth_list(const std::vector<DepthChoice>& choices, int current) {
  std::optional<int> chosen;
  for (const DepthChoice& choice : choices) {
    const bool fits = choice.refusal.empty();
    const bool is_clicked =
        ImGui::MenuItem(label_of(choice).c_str(), nullptr, choice.depth == current, fits);
    if (noted("Depth " + std::to_string(choice.depth), is_clicked)) chosen = choice.depth;
  }
  return chosen;
}

int default_of(const std::vector<DepthChoice>& choices) {
  for (const DepthChoice& choice : choices)
    if (choice.is_default) return choice.depth;
  BURNISH_CHECK(false, "a depth is the default");
  return 0;
}

}  // namespace burnish
