#include "server/fleet/membership.h"

#include <utility>

#include <spdlog/spdlog.h>

#include "common/base/clock.h"
#include "server/metrics/metrics.h"

namespace burnish {

static constexpr auto kGoing = std::chrono::seconds(2);
static constexpr char kApplication[] = "burnish fleet";

static PgPatience patience_of(const LeaseTimes& times) {
  return {times.heartbeat, times.heartbeat};
}

Result<std::unique_ptr<Membership>> Membership::join(const PgAddress& address,
                                                     const NodeFacts& node,
                                                     const LeaseTimes& times) {
  ASSIGN_OR_RETURN(PgConnection connection, PgConnection::open(address, {}, kApplication));
  std::string life = new_life();
  // The database needs a moment until it notices that a killed server's connections are gone.
  const Time end = std::chrono::steady_clock::now() + kGoing;
  for (;;) {
    const PgOutcome entered = connection.transact(enter_life(node, life, times.lease));
    RETURN_IF_ERROR(entered.why);
    if (entered.replies.back().affected() > 0) break;
    if (std::chrono::steady_clock::now() < end) {
      std::this_thread::sleep_for(kGoing / 20);
      continue;
    }
    return failed_precondition("a server runs in the fleet as '" + node.name +
                               "', and its lease lives; stop it, or give this one another "
                               "fleet.name");
  }
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

// After a failure the next try comes sooner: a short absence of the database costs no lease. Work
// after a heartbeat that takes long does not put off the next one.
void Membership::loop(const std::stop_token& stop) {
  while (!stop.stop_requested()) {
    const Time begin = std::chrono::steady_clock::now();
    const bool is_draining = is_told_to_drain();
    const Status status = beat(is_draining);
    if (!status.is_ok()) {
      good_since_.reset();
      note_others({}, is_draining);
      spdlog::warn("fleet: no heartbeat: {}", status.message());
    }
    std::unique_lock lock(mutex_);
    const auto interval = status.is_ok() ? times_.heartbeat : times_.heartbeat / 4;
    changed_.wait_until(lock, stop, begin + interval,
                        [this] { return is_draining_ && !has_told_drain_; });
  }
}

std::vector<FleetServer> Membership::drain() {
  std::unique_lock lock(mutex_);
  is_draining_ = true;
  changed_.notify_all();
  changed_.wait(lock, [this] { return has_told_drain_; });
  return others_;
}

bool Membership::is_told_to_drain() {
  const std::lock_guard lock(mutex_);
  return is_draining_;
}

void Membership::note_others(std::vector<FleetServer> others, bool has_told_drain) {
  const std::lock_guard lock(mutex_);
  others_ = std::move(others);
  has_told_drain_ |= has_told_drain;
  changed_.notify_all();
}

Status Membership::beat(bool is_draining) {
  if (!connection_.is_open()) {
    ASSIGN_OR_RETURN(connection_, PgConnection::open(address_, patience_of(times_), kApplication));
  }
  NodeLoad load = duties_.load ? duties_.load() : NodeLoad();
  load.is_draining = is_draining;
  const Time sent = std::chrono::steady_clock::now();
  ASSIGN_OR_RETURN(const PgReply renewed, connection_.run(renew_lease(life_, times_.lease, load)));
  const Time now = std::chrono::steady_clock::now();
  metrics().observe(Measure::kDatabaseRoundTripSeconds, ms_between(sent, now) / 1e3);
  if (renewed.affected() == 0) RETURN_IF_ERROR(begin_another_life(load));
  renewed_ = sent;
  if (!good_since_) good_since_ = now;
  RETURN_IF_ERROR(reap(now));
  return look_around(is_draining);
}

Status Membership::look_around(bool is_draining) {
  ASSIGN_OR_RETURN(const PgReply servers, connection_.run(read_servers()));
  std::vector<std::string> addresses;
  std::vector<FleetServer> others;
  for (size_t row = 0; row < servers.rows(); ++row) {
    const ServerPlace place{servers.bytes(row, 1), servers.bytes(row, 0)};
    if (!place.address.empty()) addresses.push_back(place.address);
    if (place.node != node_.name)
      others.push_back({place, static_cast<uint64_t>(servers.integer(row, 2))});
  }
  note_others(std::move(others), is_draining);
  if (duties_.on_heartbeat) duties_.on_heartbeat(std::move(addresses));
  return Status::ok();
}

// The sessions go in any case: somebody has ended this life.
Status Membership::begin_another_life(const NodeLoad& load) {
  spdlog::error("fleet: the lease of server {} was over; it lets go of all sessions", node_.name);
  good_since_.reset();
  life_ = new_life();
  if (duties_.on_new_life) duties_.on_new_life(life_);
  const PgOutcome entered =
      connection_.transact(enter_life_of_free_name(node_, life_, times_.lease, load));
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
