#include "server/live/successors.h"

#include <algorithm>

namespace burnish {

std::optional<ServerPlace> Successors::next(uint64_t bytes) {
  const auto roomiest = std::ranges::max_element(servers_, {}, &Server::bytes_free);
  if (roomiest == servers_.end()) return std::nullopt;
  roomiest->bytes_free -= std::min(roomiest->bytes_free, bytes);
  return roomiest->place;
}

}  // namespace burnish
