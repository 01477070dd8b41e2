#include "client/app/window/panels_copy.h"

#include <imgui.h>
#include <span>

namespace burnish {

template <typename T>
static void append(const T& values, std::vector<std::byte>& bytes) {
  const auto part = std::as_bytes(std::span(values.Data, static_cast<size_t>(values.Size)));
  bytes.insert(bytes.end(), part.begin(), part.end());
}

bool PanelsCopy::take(const ImDrawData& drawn) {
  now_.clear();
  for (int i = 0; i < drawn.CmdListsCount; ++i) {
    const ImDrawList& list = *drawn.CmdLists[i];
    append(list.CmdBuffer, now_);
    append(list.IdxBuffer, now_);
    append(list.VtxBuffer, now_);
  }
  now_.swap(last_);
  return now_ != last_;
}

}  // namespace burnish
