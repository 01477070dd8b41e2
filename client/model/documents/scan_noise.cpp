#include "client/model/documents/scan_noise.h"

#include <utility>

namespace burnish {

ScanNoise::ScanNoise(std::shared_ptr<Connection> connection, std::string scan, Tasks& tasks,
                     MessageLog& log)
    : connection_(std::move(connection)), scan_(std::move(scan)), tasks_(tasks), log_(log) {}

void ScanNoise::ask() {
  if (proposal_ || std::exchange(is_asking_, true)) return;
  tasks_.start([this, alive = std::weak_ptr(alive_), connection = connection_,
                scan = scan_](const StopToken& stop) -> Tasks::Completion {
    const auto goes_on = [&](std::string_view, double) { return !stop.stop_requested(); };
    connection->bring_back(goes_on);
    const auto proposal = connection->propose_edges(scan, goes_on);
    return [this, alive, proposal] {
      if (alive.expired()) return;
      is_asking_ = false;
      if (!proposal.is_ok()) return log_.failure("noise", proposal.status());
      proposal_ = *proposal;
    };
  });
}

}  // namespace burnish
