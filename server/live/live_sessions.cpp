#include "server/live/live_sessions.h"

#include <algorithm>
#include <thread>

#include "common/pages/directory_codec.h"
#include "server/memory/memory_need.h"

namespace burnish {

static int encoder_threads() {
  return static_cast<int>(std::clamp(std::thread::hardware_concurrency(), 1u, 8u));
}

LiveSessions::LiveSessions(SessionManager& manager, int solver_threads)
    : manager_(manager),
      sources_(manager.store()),
      encoders_(encoder_threads()),
      scheduler_(solver_threads) {
  manager_.set_listener(this);
}

LiveSessions::~LiveSessions() {
  manager_.set_listener(nullptr);
}

static Status going_down() {
  return unavailable("the server is going down; connect again later");
}

Result<LiveClient> LiveSessions::join(const Greeting& greeting, const Caller& caller,
                                      SubscriberWiring wiring, const Progress& progress) {
  ASSIGN_OR_RETURN(const SessionManager::Attached attached,
                   manager_.attach(greeting.session, caller, progress));
  ASSIGN_OR_RETURN(auto pages,
                   manager_.store().open_pages(attached.info.scan_id,
                                               give_way_to(scheduler_, progress), caller.user));
  const uint64_t fingerprint = pages_fingerprint(pages->file.head_bytes());
  auto memory = manager_.memory().take(kServer, predict_client_bytes({}));
  if (!memory.is_ok())
    return memory.status().with_context("frames for a client of session " + attached.info.name);
  const std::lock_guard lock(mutex_);
  if (draining_) return going_down();
  std::shared_ptr<LiveSession>& session = sessions_[attached.info.id];
  if (!session) session = std::make_shared<LiveSession>(manager_, scheduler_, attached);
  wiring.on_wish = [weak = std::weak_ptr(session)] {
    if (const auto live = weak.lock()) live->wake_for_frames();
  };
  const uint64_t connection = attached.entry->presence.join(caller.user);
  auto wishes = std::make_unique<PageWishes>(sources_.find_or_make(std::move(pages), attached.mesh),
                                             greeting, std::move(memory).value());
  auto subscriber = std::make_shared<Subscriber>(connection, caller, std::move(wishes), encoders_,
                                                 std::move(wiring));
  session->join(subscriber);
  return LiveClient{session, subscriber,
                    Welcome{attached.info, connection, role_in(attached.roles, caller), fingerprint,
                            attached.backend, fleet_}};
}

void LiveSessions::leave(const LiveClient& client) {
  const std::lock_guard lock(mutex_);
  if (client.session->leave(client.subscriber->connection))
    sessions_.erase(client.welcome.session.id);
}

void LiveSessions::set_fleet(std::vector<std::string> addresses) {
  const std::lock_guard lock(mutex_);
  fleet_ = std::move(addresses);
}

std::vector<std::string> LiveSessions::fleet() const {
  const std::lock_guard lock(mutex_);
  return fleet_;
}

void LiveSessions::drain(Successors successors) {
  std::map<std::string, std::shared_ptr<LiveSession>> sessions;
  const std::vector<std::string> others = fleet();
  {
    const std::lock_guard lock(mutex_);
    draining_ = true;
    sessions = sessions_;
  }
  for (const auto& [id, session] : sessions)
    session->close({GoAwayCode::kGoingDown, going_down().message(), true,
                    successors.next(session->session_bytes()), others});
}

void LiveSessions::end_unwelcome() {
  std::map<std::string, std::shared_ptr<LiveSession>> sessions;
  {
    const std::lock_guard lock(mutex_);
    sessions = sessions_;
  }
  for (const auto& [id, session] : sessions) session->end_unwelcome(kSilenceMax);
}

LiveSessions::Usage LiveSessions::usage() const {
  const std::lock_guard lock(mutex_);
  Usage usage;
  usage.waiting_sessions = scheduler_.waiting();
  for (const auto& [id, session] : sessions_) {
    usage.queued_edits += session->queued_edits();
    usage.credits += session->credits();
    usage.client_bytes += session->client_bytes();
  }
  return usage;
}

std::shared_ptr<LiveSession> LiveSessions::find(const std::string& id) const {
  const std::lock_guard lock(mutex_);
  const auto found = sessions_.find(id);
  return found == sessions_.end() ? nullptr : found->second;
}

void LiveSessions::on_session_changed(const std::string& id) {
  if (const auto session = find(id)) session->wake();
}

uint64_t LiveSessions::client_bytes(const std::string& id) const {
  const auto session = find(id);
  return session ? session->client_bytes() : 0;
}

void LiveSessions::on_session_left(const std::string& id, const Status& why) {
  const auto session = find(id);
  if (!session) return;
  session->close({GoAwayCode::kClosed, why.message(), false});
  session->wake();  // to answer the remaining edits
}

void LiveSessions::on_session_lost(const std::string& id, const Status& why) {
  const auto session = find(id);
  if (!session) return;
  session->close({GoAwayCode::kFailed, why.message(), true});
  session->wake();  // to answer the remaining edits
}

void LiveSessions::on_session_moved(const std::string& id, const Status& why) {
  const auto session = find(id);
  if (session) session->abandon(why, fleet());
}

}  // namespace burnish
