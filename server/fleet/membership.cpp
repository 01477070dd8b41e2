#include "server/fleet/membership.h"

#include <condition_variable>
#include <mutex>
#include <utility>

#include <spdlog/spdlog.h>

#include "common/base/clock.h"
#include "server/metrics/metrics.h"

namespace burnish {

static constexpr char kApplication[] = "burnish fleet";

static PgPatience patience_of(const LeaseTimes& times) {
  return {times.heartbeat, times.heartbeat};
}

Result<std::unique_ptr<Membership>> Membership::join(const PgAddress& address,
                                                     const NodeFacts& node,
                                                     const LeaseTimes& times) {
  ASSIGN_OR_RETURN(PgConnection connection, PgConnection::open(address, {}, kApplication));
  std::string life = new_life();
  const PgOutcome entered = connection.transact(enter_life(node, life, times.lease));
  RETURN_IF_ERROR(entered.why);
  if (entered.replies.back().affected() == 0)
    return failed_precondition("another server joined the fleet as '" + node.name +
                               "' at this moment");
  return std::unique_ptr<Membership>(
      new Membership(address, node, times, std::move(connection), std::move(life)));
}

Membership::Membership(const PgAddress& address, const NodeFacts& node, const LeaseTimes& times,
                       PgConnection connection, std::string life)
    : address_(address),
      node_(node),
      times_(times),
      first_life_(std::move(life)),
      connection_(std::move(connection)),
      life_(first_life_),
      renewed_(std::chrono::steady_clock::now()) {}

Membership::~Membership() {
  if (connection_.is_open()) (void)connection_.run(end_life(life_));
}

std::jthread Membership::start(MemberDuties duties) {
  duties_ = std::move(duties);
  return std::jthread([this](const std::stop_token& stop) { loop(stop); });
}

std::chrono::duration<double> Membership::lease_left() const {
  return times_.lease - (std::chrono::steady_clock::now() - renewed_.load());
}

void Membership::loop(const std::stop_token& stop) {
  std::mutex mutex;
  std::condition_variable_any wake;
  std::unique_lock lock(mutex);
  while (!stop.stop_requested()) {
    const Status status = beat();
    if (!status.is_ok()) {
      good_since_.reset();
      spdlog::warn("fleet: no heartbeat: {}", status.message());
    }
    wake.wait_for(lock, stop, times_.heartbeat, [] { return false; });
  }
}

Status Membership::beat() {
  if (!connection_.is_open()) {
    ASSIGN_OR_RETURN(connection_, PgConnection::open(address_, patience_of(times_), kApplication));
  }
  const Time sent = std::chrono::steady_clock::now();
  const NodeLoad load = duties_.load ? duties_.load() : NodeLoad();
  ASSIGN_OR_RETURN(const PgReply renewed, connection_.run(renew_lease(life_, times_.lease, load)));
  const Time now = std::chrono::steady_clock::now();
  metrics().observe(Measure::kDatabaseRoundTripSeconds, ms_between(sent, now) / 1e3);
  if (renewed.affected() == 0) RETURN_IF_ERROR(begin_another_life());
  renewed_ = sent;
  if (!good_since_) good_since_ = now;
  RETURN_IF_ERROR(reap(now));
  if (!duties_.on_heartbeat) return Status::ok();
  ASSIGN_OR_RETURN(const PgReply addresses, connection_.run(read_addresses()));
  std::vector<std::string> fleet;
  for (size_t row = 0; row < addresses.rows(); ++row) fleet.push_back(addresses.bytes(row, 0));
  duties_.on_heartbeat(std::move(fleet));
  return Status::ok();
}

// The sessions go in any case: somebody has ended this life.
Status Membership::begin_another_life() {
  spdlog::error("fleet: the lease of server {} was over; it lets go of all sessions", node_.name);
  good_since_.reset();
  life_ = new_life();
  if (duties_.on_new_life) duties_.on_new_life(life_);
  const PgOutcome entered =
      connection_.transact(enter_life_of_free_name(node_, life_, times_.lease));
  RETURN_IF_ERROR(entered.why);
  if (entered.replies.back().affected() > 0) return Status::ok();
  return failed_precondition("another server has the name '" + node_.name +
                             "'; give each server a fleet.name of its own");
}

Status Membership::reap(Time now) {
  if (now - *good_since_ < times_.lease) return Status::ok();
  const PgOutcome reaped = connection_.transact(end_dead_lives(life_));
  RETURN_IF_ERROR(reaped.why);
  const uint64_t ended = reaped.replies.back().affected();
  if (ended > 0) spdlog::warn("fleet: the leases of {} servers were over", ended);
  return Status::ok();
}

}  // namespace burnish
