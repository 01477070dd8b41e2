#include "client/surface/server_room.h"

#include <algorithm>

namespace burnish {

void ServerRoom::refuse(uint64_t vertices, Time now) {
  refused_ = vertices;
  max_ = std::max(vertices / 2, kVerticesMin);
  pause_ = std::min(2 * pause_, kPauseMax);
  rises_at_ = now + pause_;
}

// A refused number of pages may be tried again: others may have left the server.
uint64_t ServerRoom::vertices_max(Time now) {
  if (max_ == 0 || now < rises_at_) return max_;
  max_ += max_ / 8;
  rises_at_ = now + pause_;
  if (max_ > refused_) max_ = 0;
  return max_;
}

}  // namespace burnish
