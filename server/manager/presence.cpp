#include "server/manager/presence.h"

#include <algorithm>
#include <array>

namespace burnish {

// People with any colour vision can tell these apart on a grey surface (after Okabe and Ito).
static constexpr std::array<uint32_t, 7> kColours = {0xE69F00, 0x56B4E9, 0x009E73, 0xF0E442,
                                                     0x0072B2, 0xD55E00, 0xCC79A7};

uint64_t Presence::join(const std::string& user) {
  const std::lock_guard lock(mutex_);
  const uint64_t connection = ++last_connection_;
  present_[connection] = {connection, user, free_colour(), {}};
  ++version_;
  return connection;
}

void Presence::leave(uint64_t connection) {
  const std::lock_guard lock(mutex_);
  version_ += present_.erase(connection);
}

void Presence::move_brush(uint64_t connection, const std::optional<BrushRing>& ring) {
  const std::lock_guard lock(mutex_);
  const auto found = present_.find(connection);
  if (found == present_.end() || found->second.ring == ring) return;
  found->second.ring = ring;
  ++version_;
}

std::vector<PresentUser> Presence::list() const {
  const std::lock_guard lock(mutex_);
  std::vector<PresentUser> users;
  for (const auto& [connection, user] : present_) users.push_back(user);
  return users;
}

uint64_t Presence::version() const {
  const std::lock_guard lock(mutex_);
  return version_;
}

uint32_t Presence::free_colour() const {
  const auto uses = [this](uint32_t colour) {
    return std::count_if(present_.begin(), present_.end(),
                         [&](const auto& entry) { return entry.second.colour == colour; });
  };
  return *std::min_element(kColours.begin(), kColours.end(),
                           [&](uint32_t a, uint32_t b) { return uses(a) < uses(b); });
}

}  // namespace burnish
