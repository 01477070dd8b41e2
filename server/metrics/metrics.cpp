#include "server/metrics/metrics.h"

#include <atomic>

namespace burnish {

static Metrics none;
static std::atomic<Metrics*> current{&none};
static std::shared_ptr<Metrics> owner;

Metrics& metrics() {
  return *current.load(std::memory_order_acquire);
}

void set_metrics(std::shared_ptr<Metrics> kept) {
  current.store(kept ? kept.get() : &none, std::memory_order_release);
  owner = std::move(kept);
}

}  // namespace burnish
