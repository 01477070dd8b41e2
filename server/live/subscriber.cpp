#include "server/live/subscriber.h"

#include <algorithm>
#include <chrono>
#include <optional>

#include <spdlog/spdlog.h>

#include "server/metrics/metrics.h"
#include "server/process/minute_limiter.h"

namespace burnish {

using std::chrono::steady_clock;

static double ms_since(steady_clock::time_point then) {
  return std::chrono::duration<double, std::milli>(steady_clock::now() - then).count();
}

static constexpr size_t kAnswersMax = 64;     // answers that the client has not taken
static constexpr size_t kUnansweredMax = 64;  // messages of edits
static constexpr size_t kUnansweredBytesMax = size_t{16} << 20;

static std::optional<Refusal> reason_of_refused_edits(StatusCode code) {
  if (code == StatusCode::kResourceExhausted) return Refusal::kLimit;
  if (code == StatusCode::kPermissionDenied) return Refusal::kPermission;
  return std::nullopt;
}

// Counts a refusal of a client's edits among the refusals if a limit or a role is why, and logs one
// of each kind a minute. An ordinary call's end does the same; a live stream goes on.
static void report_refused_edits(const EditsRefused& refused) {
  static MinuteLimiter limiter;
  const auto reason = reason_of_refused_edits(refused.status.code());
  if (!reason) return;
  metrics().count_refusal(*reason);
  const bool is_limit = *reason == Refusal::kLimit;
  const auto turn = limiter.take(is_limit ? "limit" : "role", steady_clock::now());
  if (turn.is_admitted)
    spdlog::warn("refused edits of a live client ({} more since the last such line): {}",
                 turn.left_out, refused.status.to_string());
}

Subscriber::Subscriber(uint64_t own_connection, Caller own_caller,
                       std::unique_ptr<PageWishes> wishes, Executor& encoders,
                       SubscriberWiring wiring)
    : connection(own_connection),
      caller(std::move(own_caller)),
      wishes_(std::move(wishes)),
      encoders_(encoders),
      wiring_(std::move(wiring)),
      encoder_(wishes_->made()->kind) {}

void Subscriber::on_message() const {
  if (wiring_.on_message) wiring_.on_message();
}
void Subscriber::on_wish() const {
  if (wiring_.on_wish) wiring_.on_wish();
}

void Subscriber::beat(uint64_t client_time_us) {
  {
    const std::lock_guard lock(mutex_);
    client_time_us_ = client_time_us;
    last_beat_ = steady_clock::now();
    if (!closed_) echo_ = {client_time_us};
  }
  on_message();
}

void Subscriber::heard() {
  const std::lock_guard lock(mutex_);
  last_heard_ = steady_clock::now();
}

bool Subscriber::is_silent(steady_clock::duration time) const {
  const std::lock_guard lock(mutex_);
  return !wiring_.may_be_silent && unanswered_ == 0 && steady_clock::now() - last_heard_ > time;
}

void Subscriber::dismiss(const std::string& why, steady_clock::duration time) {
  close(GoAway{GoAwayCode::kRemoved, why, false});
  {
    const std::lock_guard lock(mutex_);
    if (!dismissed_) dismissed_ = steady_clock::now();
    if (steady_clock::now() - *dismissed_ < time) return;
  }
  cut();
}

bool Subscriber::may_send() const {
  const std::lock_guard lock(mutex_);
  return answers_.size() < kAnswersMax && unanswered_ < kUnansweredMax &&
         unanswered_bytes_ < kUnansweredBytesMax;
}

bool Subscriber::expect_answer(size_t bytes) {
  const std::lock_guard lock(mutex_);
  if (closed_) return false;
  ++unanswered_;
  unanswered_bytes_ += bytes;
  return true;
}

void Subscriber::acknowledge(EditsAcknowledged answered, size_t bytes) {
  answer(std::move(answered), bytes);
}

void Subscriber::refuse(EditsRefused answered, size_t bytes) {
  report_refused_edits(answered);
  answer(std::move(answered), bytes);
}

void Subscriber::answer(ServerMessage message, size_t bytes) {
  {
    const std::lock_guard lock(mutex_);
    --unanswered_;
    unanswered_bytes_ -= bytes;
    last_heard_ = steady_clock::now();  // the server may not have read it while it waited
    if (is_abandoned_) return;
    answers_.push_back(std::move(message));
  }
  on_message();
}

void Subscriber::refuse_unexpected(EditsRefused answered) {
  report_refused_edits(answered);
  {
    const std::lock_guard lock(mutex_);
    if (closed_) return;
    answers_.push_back(std::move(answered));
  }
  on_message();
}

void Subscriber::tell(std::shared_ptr<const SessionPeople> people) {
  {
    const std::lock_guard lock(mutex_);
    if (closed_) return;
    people_ = std::move(people);
  }
  on_message();
}

void Subscriber::tell(const HistoryState& history) {
  {
    const std::lock_guard lock(mutex_);
    if (closed_) return;
    history_ = history;
  }
  on_message();
}

void Subscriber::close(std::optional<GoAway> go_away) {
  {
    const std::lock_guard lock(mutex_);
    if (closed_) return;
    close_held(std::move(go_away));
  }
  on_message();
}

void Subscriber::close_held(std::optional<GoAway> go_away) {
  closed_ = true;
  go_away_ = std::move(go_away);
  people_.reset();
  history_.reset();
  echo_.reset();
  frame_.reset();
}

void Subscriber::abandon(GoAway go_away) {
  {
    const std::lock_guard lock(mutex_);
    is_abandoned_ = true;
    const bool is_leaving = closed_ && !go_away_;  // by itself, or it has taken another go_away
    if (!is_leaving) close_held(std::move(go_away));
  }
  on_message();
}

std::optional<ServerMessage> Subscriber::take() {
  std::optional<ServerMessage> message;
  bool took_frame = false;
  {
    const std::lock_guard lock(mutex_);
    if (!answers_.empty()) {
      message = std::move(answers_.front());
      answers_.pop_front();
    } else if (echo_) {
      message = *std::exchange(echo_, std::nullopt);
    } else if (frame_) {
      if (frame_->stats.client_time_us != 0) frame_->stats.held_ms = ms_since(frame_beat_);
      message = *std::exchange(frame_, std::nullopt);
      making_frame_ = false;
      took_frame = true;
    } else if (history_) {
      message = *std::exchange(history_, std::nullopt);
    } else if (people_) {
      message = *std::exchange(people_, nullptr);
    } else if (go_away_ && (unanswered_ == 0 || is_abandoned_)) {
      message = *std::exchange(go_away_, std::nullopt);
    }
  }
  if (took_frame) on_wish();
  return message;
}

bool Subscriber::is_closed() const {
  const std::lock_guard lock(mutex_);
  return closed_;
}

bool Subscriber::is_finished() const {
  const std::lock_guard lock(mutex_);
  return closed_ && answers_.empty() && !go_away_ && (unanswered_ == 0 || is_abandoned_);
}

uint32_t Subscriber::credits() const {
  const std::lock_guard lock(mutex_);
  return credits_;
}

uint64_t Subscriber::byte_count() const {
  const std::lock_guard lock(mutex_);
  return encoder_bytes_ + (frame_ ? frame_->data.size() : 0) + wishes_->byte_count();
}

}  // namespace burnish
