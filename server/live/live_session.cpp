#include "server/live/live_session.h"

#include <algorithm>
#include <chrono>
#include <string>
#include <utility>

#include <spdlog/spdlog.h>

#include "common/base/clock.h"
#include "server/metrics/metrics.h"

namespace burnish {

using std::chrono::steady_clock;

/// Bounds a replay's part of a turn: many long strokes take many turns, and other sessions have
/// theirs in between. The first call always returns true, so every slice makes progress.
static Progress for_a_slice() {
  static constexpr auto kSlice = std::chrono::milliseconds(10);
  return [end = steady_clock::now() + kSlice, first = true](std::string_view, double) mutable {
    return std::exchange(first, false) || steady_clock::now() < end;
  };
}

LiveSession::LiveSession(SessionManager& manager, Scheduler& scheduler,
                         const SessionManager::Attached& attached)
    : manager_(manager),
      scheduler_(scheduler),
      entry_(attached.entry),
      is_unmoved_(attached.cycles == 0),
      roles_(attached.roles) {}

void LiveSession::wake() {
  scheduler_.wake(shared_from_this());
}

bool LiveSession::turn() {
  bool more = false;
  run_guarded([&] { more = take_turn(); }, [&](const Status& why) { fail(why); });
  return more;
}

bool LiveSession::take_turn() {
  if (is_over()) {
    ticket_.reset();
    return false;
  }
  if (is_coming_back_) return false;
  if (!ticket_)
    ticket_.emplace(entry_->mutex, [weak = weak_from_this()] {
      if (const auto self = weak.lock()) self->wake();
    });
  auto turn = manager_.try_turn(entry_, *ticket_);
  Status status = turn.status();
  bool more = false;
  if (status.is_ok()) {
    if (!turn.value()) return false;  // somebody else works on it; woken when it is free
    SessionTurn& at = *turn.value();
    if (!at.is_in_memory()) return bring_back(at), false;
    status = work(at, more);
  }
  if (status.is_ok()) return more;
  fail(status);
  return false;
}

void LiveSession::bring_back(SessionTurn& at) {
  is_coming_back_ = true;
  at.bring_back_later([weak = weak_from_this()](const Status& status) {
    const auto self = weak.lock();
    if (!self) return;
    self->is_coming_back_ = false;
    status.is_ok() ? self->wake() : self->fail(status);
  });
}

/// Does one turn's work on the session. `more`: there is more to do.
Status LiveSession::work(SessionTurn& at, bool& more) {
  for (EditMessage& message : take_edits()) apply(at, std::move(message));
  more = true;
  if (at.is_solving() || !at.catch_up(for_a_slice())) return Status::ok();
  show_gestures(at);
  const Status relaxed = relax(at);
  // An edit or a preview that moves nothing also gets its frame, because clients wait for it. An
  // export may have relaxed the surface further.
  const Seen now{at.edits(), at.last().cycle, at.session().surface_revision(), previews_taken_};
  if (std::exchange(seen_, now) != now) ++version_;
  if (now.cycle > 0) is_unmoved_ = false;
  tell_state(at);
  RETURN_IF_ERROR(relaxed);
  more = !at.session().is_settled(at.last()) || queued_edits() > 0;
  return send_frames(at);
}

/// Returns whether a turn helps nobody here: clients that were told to go only wait for answers.
bool LiveSession::is_over() const {
  const std::lock_guard lock(mutex_);
  if (slots_.empty()) return true;
  return edits_.empty() && std::ranges::all_of(slots_, [](const auto& slot) {
           return slot.second.subscriber->is_closed();
         });
}

void LiveSession::take_step(const StepReport& step, StepReport& last) {
  if (step.fell_back && !last.fell_back) {
    metrics().add(Count::kFallBacks, 1);
    spdlog::warn("session {}: a step of the solver was not sound; a plainer smoother goes on",
                 entry_->record.id);
  }
  last = step;
}

Status LiveSession::relax(SessionTurn& at) {
  Session& session = at.session();
  if (session.is_settled(at.last())) return Status::ok();
  const auto start = steady_clock::now();
  const bool is_assembled = session.is_changed();
  if (is_assembled) session.update();
  const auto assembled = steady_clock::now();
  if (!session.is_settled(at.last())) take_step(session.step(), at.last());  // a gain needs none
  RETURN_IF_ERROR(session.status());
  assemble_ms_ = is_assembled ? ms_between(start, assembled) : 0;
  solve_ms_ = ms_between(assembled, steady_clock::now());
  if (is_assembled) metrics().observe(Measure::kFrameAssembleSeconds, assemble_ms_ / 1e3);
  metrics().observe(Measure::kFrameSolveSeconds, solve_ms_ / 1e3);
  return Status::ok();
}

void LiveSession::tell_state(SessionTurn& at) {
  const HistoryState history{at.edits(), at.session().fields().settings()};
  bool roles_changed = false, history_changed = false;
  {
    const std::lock_guard lock(mutex_);
    roles_changed = std::exchange(roles_version_, at.roles_version()) != at.roles_version();
    if (roles_changed) roles_ = at.roles();
    history_changed = history_ != history;
    history_ = history;
  }
  if (roles_changed) tell_people();
  if (!history_changed) return;
  for (const auto& subscriber : subscribers()) subscriber->tell(history);
}

void LiveSession::join(const std::shared_ptr<Subscriber>& subscriber) {
  std::optional<HistoryState> history;
  {
    const std::lock_guard lock(mutex_);
    slots_[subscriber->connection] = {subscriber};
    history = history_;
  }
  if (history) subscriber->tell(*history);
  tell_people();
  wake();
}

bool LiveSession::leave(uint64_t connection) {
  entry_->presence.leave(connection);
  bool is_empty = false;
  {
    const std::lock_guard lock(mutex_);
    slots_.erase(connection);
    if (gestures_.erase(connection) > 0) changed_gestures_.insert(connection);
    is_empty = slots_.empty();
  }
  tell_people();
  wake();
  return is_empty;
}

void LiveSession::move_brush(uint64_t connection, const std::optional<BrushRing>& ring) {
  const uint64_t before = entry_->presence.version();
  entry_->presence.move_brush(connection, ring);
  if (entry_->presence.version() != before) tell_people();
}

void LiveSession::tell_people() {
  auto people = std::make_shared<SessionPeople>();
  people->present = entry_->presence.list();
  {
    const std::lock_guard lock(mutex_);
    people->roles = roles_;
  }
  for (const auto& subscriber : subscribers()) subscriber->tell(people);
}

void LiveSession::close(const GoAway& go_away) {
  for (const auto& subscriber : subscribers()) subscriber->close(go_away);
}

void LiveSession::abandon(const Status& why, const std::vector<std::string>& fleet) {
  GoAway go_away{GoAwayCode::kNotOwner, why.message(), true, std::nullopt, fleet};
  if (!why.moved_to().empty()) go_away.moved_to = ServerPlace::of(why.moved_to());
  for (const auto& subscriber : subscribers()) subscriber->abandon(go_away);
  refuse_waiting(unavailable(why.message()));
}

// Also answers waiting edits, because a go_away comes after the last answer.
void LiveSession::fail(const Status& why) {
  if (!why.moved_to().empty()) return abandon(why, {});
  spdlog::error("session {}: {}", entry_->record.id, why.to_string());
  const bool come_back = why.code() != StatusCode::kNotFound;
  close({come_back ? GoAwayCode::kFailed : GoAwayCode::kClosed, why.message(), come_back});
  refuse_waiting(come_back ? unavailable(why.message()) : why);
}

static std::string silence_text(steady_clock::duration limit) {
  const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(limit).count();
  return "the client has sent nothing for " + std::to_string(seconds) + " s";
}

void LiveSession::end_unwelcome(steady_clock::duration silence_max) {
  static constexpr auto kTimeToTakeIt = std::chrono::seconds(5);
  for (const auto& subscriber : subscribers()) {
    const auto stays = subscriber->may_stay();
    if (!stays.is_ok()) subscriber->dismiss(stays.message(), kTimeToTakeIt);
    if (!subscriber->is_silent(silence_max)) continue;
    subscriber->close(GoAway{GoAwayCode::kSilent, silence_text(silence_max), true});
    if (subscriber->is_silent(silence_max + kTimeToTakeIt)) subscriber->cut();
  }
}

uint64_t LiveSession::credits() const {
  uint64_t sum = 0;
  for (const auto& subscriber : subscribers()) sum += subscriber->credits();
  return sum;
}

uint64_t LiveSession::client_bytes() const {
  uint64_t sum = 0;
  for (const auto& subscriber : subscribers()) sum += subscriber->byte_count();
  return sum;
}

size_t LiveSession::queued_edits() const {
  const std::lock_guard lock(mutex_);
  return edits_.size();
}

std::vector<std::shared_ptr<Subscriber>> LiveSession::subscribers() const {
  const std::lock_guard lock(mutex_);
  std::vector<std::shared_ptr<Subscriber>> all;
  for (const auto& [connection, slot] : slots_) all.push_back(slot.subscriber);
  return all;
}

}  // namespace burnish
