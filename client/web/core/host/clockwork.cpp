#include "client/web/core/host/clockwork.h"

#include <algorithm>
#include <vector>

namespace burnish {

static std::vector<Clockwork*>& clockworks() {
  static auto* const the = new std::vector<Clockwork*>();  // lives as long as the page
  return *the;
}

Clockwork::Clockwork() {
  clockworks().push_back(this);
}

Clockwork::~Clockwork() {
  std::erase(clockworks(), this);
}

Clockwork::Time Clockwork::ask_all(Time now) {
  Time next = Time::max();
  for (Clockwork* const each : std::vector(clockworks())) next = std::min(next, each->on_time(now));
  return next;
}

}  // namespace burnish
