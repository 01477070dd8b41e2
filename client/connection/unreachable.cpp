#include "client/connection/unreachable.h"

#include <string_view>
#include <utility>

namespace burnish {

std::string why_unreachable(const std::string& reason) {
  static constexpr std::pair<std::string_view, std::string_view> kWords[] = {
      {"DNS resolution failed", "its name is not known here"},
      {"C-ares status", "its name is not known here"},
      {"Connection refused", "no program listens there; does burnish-server run?"},
      {"No route to host", "there is no way to it in the network"},
      {"Network is unreachable", "this computer is not in the network"},
      {"WRONG_VERSION_NUMBER", "it does not speak TLS; try without encryption"},
      {"Socket closed", "it hung up; perhaps it wants TLS"},
  };
  for (const auto& [part, words] : kWords)
    if (reason.find(part) != std::string::npos) return std::string(words);
  return reason.empty() ? "it does not answer" : reason;
}

}  // namespace burnish
