#include "client/live/live_news.h"

namespace burnish {

const char* link_state_name(LinkState state) {
  switch (state) {
    case LinkState::kConnecting:
      return "connecting";
    case LinkState::kLive:
      return "live";
    case LinkState::kLost:
      return "lost";
    case LinkState::kEnded:
      break;
  }
  return "ended";
}

}  // namespace burnish
