#include "server/live/subscriber.h"

#include <algorithm>

#include "server/metrics/metrics.h"

namespace burnish {

using std::chrono::steady_clock;

// A frame that touches few pages must not round the others anew, so after an exact frame the finest
// step is tried first.
static StepChoice steps_of(bool settled, bool last_was_exact, uint32_t bytes_max) {
  if (settled) return kStillSteps;
  StepChoice steps = moving_steps(bytes_max == 0 ? SIZE_MAX : bytes_max);
  if (last_was_exact) steps.finest = 0;
  return steps;
}

static double ms_since(steady_clock::time_point then) {
  return std::chrono::duration<double, std::milli>(steady_clock::now() - then).count();
}

static constexpr size_t kAnswersMax = 64;     // answers that the client has not taken
static constexpr size_t kUnansweredMax = 64;  // messages of edits
static constexpr size_t kUnansweredBytesMax = size_t{16} << 20;

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

/// No encoder remembers more frames than this.
static void append_newest(const std::vector<uint64_t>& sequences, std::vector<uint64_t>& all) {
  static constexpr size_t kRemembered = 2 * kPageFramesInFlightMax;
  all.insert(all.end(), sequences.begin(), sequences.end());
  if (all.size() > kRemembered) all.erase(all.begin(), all.end() - kRemembered);
}

void Subscriber::grant(const FrameCredit& credit) {
  {
    const std::lock_guard lock(mutex_);
    credits_ = std::min(credits_ + std::min(credit.frames, kCreditsMax), kCreditsMax);
    append_newest(credit.decoded, unseen_.decoded);
    append_newest(credit.refused, unseen_.refused);
    unseen_.key_frame |= credit.key_frame;
    unseen_.frame_bytes = credit.frame_bytes;
    holds_frame_ |= std::ranges::any_of(
        credit.decoded, [this](uint64_t sequence) { return sequence >= first_sequence_; });
    if (!credit.refused.empty() || credit.key_frame) {
      holds_frame_ = false;
      shown_version_.reset();
    }
    key_frame_allowed_ = true;
  }
  on_wish();
}

Status Subscriber::show_pages(const ShowPages& change) {
  ASSIGN_OR_RETURN(const bool must_make, wishes_->want(change));
  if (must_make) post_pages();
  return Status::ok();
}

// Weak: nobody needs the pages of a client that has gone.
void Subscriber::post_pages() {
  const auto fail = [](Subscriber& self, const Status& why) {
    self.close(Farewell{"the server cannot show the pages: " + why.message(), true});
  };
  const auto make = [weak = weak_from_this(), fail] {
    const auto self = weak.lock();
    if (!self || self->is_closed()) return;
    const auto more = self->wishes_->make_some();
    if (!more.is_ok()) return fail(*self, more.status());
    if (*more) self->post_pages();
    self->on_wish();
  };
  encoders_.post({.work = make, .on_failure = [weak = weak_from_this(), fail](const Status& why) {
                    if (const auto self = weak.lock()) fail(*self, why);
                  }});
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
  close(Farewell{why, false});
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
  answer(std::move(answered), bytes);
}

void Subscriber::answer(ServerMessage message, size_t bytes) {
  {
    const std::lock_guard lock(mutex_);
    --unanswered_;
    unanswered_bytes_ -= bytes;
    last_heard_ = steady_clock::now();  // the server may not have read it while it waited
    answers_.push_back(std::move(message));
  }
  on_message();
}

void Subscriber::refuse_unexpected(EditsRefused answered) {
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

void Subscriber::close(std::optional<Farewell> farewell) {
  {
    const std::lock_guard lock(mutex_);
    if (closed_) return;
    closed_ = true;
    farewell_ = std::move(farewell);
    people_.reset();
    history_.reset();
    echo_.reset();
    frame_.reset();
  }
  on_message();
}

bool Subscriber::wants_frame(uint64_t version, bool settled) const {
  const std::lock_guard lock(mutex_);
  if (closed_ || credits_ == 0 || making_frame_) return false;
  if (!holds_frame_ && !key_frame_allowed_) return false;
  // The first pages are about to come: an empty frame before them would cost a round trip.
  if (wishes_->is_beginning()) return false;
  return shown_version_ != version || shown_revision_ != wishes_->made()->shown.revision() ||
         (settled && !shown_settled_);
}

void Subscriber::show(Shot shot) {
  {
    const std::lock_guard lock(mutex_);
    if (closed_ || credits_ == 0 || making_frame_) return;
    --credits_;
    making_frame_ = true;
    key_frame_allowed_ = false;
    shown_version_ = shot.version;
    shown_revision_ = shot.pages->shown.revision();
    shown_settled_ = shot.stats.settled;
    shot.stats.client_time_us = client_time_us_;
    frame_beat_ = last_beat_;
  }
  const auto self = shared_from_this();
  encoders_.post(
      {.work = [self, shot = std::move(shot)] { self->encode(shot); },
       .on_failure =
           [self](const Status& why) {
             self->close(Farewell{"the server cannot make a frame: " + why.message(), true});
           }});
}

void Subscriber::hear(const FrameCredit& unseen) {
  for (const uint64_t sequence : unseen.decoded) encoder_.acknowledge(sequence);
  for (const uint64_t sequence : unseen.refused) encoder_.refuse(sequence);
  if (unseen.key_frame) encoder_.request_key_frame();
}

// The frames of one kind are no reference for the other, so a key frame comes next.
void Subscriber::begin_kind(PageFrameKind kind) {
  if (encoder_.kind() == kind) return;
  encoder_ = PageFrameEncoder(kind, encoder_.next_sequence());
  const std::lock_guard lock(mutex_);
  first_sequence_ = encoder_.next_sequence();
  holds_frame_ = false;
}

EncodedPageFrame Subscriber::encode(const Shot& shot, uint32_t bytes_max) {
  const std::vector<WantedPage> wanted = shot.surface->wanted(*shot.pages);
  EncodedPageFrame frame =
      encoder_.encode({shot.pages->shown, wanted, shot.surface->largest_move()},
                      steps_of(shot.stats.settled, last_was_exact_, bytes_max));
  last_was_exact_ = frame.step_shift == 0;
  return frame;
}

bool Subscriber::shows_the_last(const EncodedPageFrame& frame, uint32_t revision) const {
  return frame.sent_pages == 0 && frame.sent_gains == 0 && revision == last_revision_ &&
         frame.reference != 0 && frame.reference == last_sequence_;
}

void Subscriber::encode(const Shot& shot) {
  FrameCredit unseen;
  {
    const std::lock_guard lock(mutex_);
    std::swap(unseen, unseen_);
    unseen_.frame_bytes = unseen.frame_bytes;  // stays until the next credit
  }
  const auto start = steady_clock::now();
  begin_kind(shot.pages->kind);
  hear(unseen);
  const EncodedPageFrame encoded = encode(shot, unseen.frame_bytes);
  const double seconds = std::chrono::duration<double>(steady_clock::now() - start).count();
  LiveFrame frame{{}, shot.stats};
  frame.stats.encode_ms = seconds * 1e3;
  const uint32_t revision = shot.pages->shown.revision();
  if (!shows_the_last(encoded, revision)) {
    frame.data.assign(encoded.bytes.begin(), encoded.bytes.end());
    last_sequence_ = encoded.sequence;
    last_revision_ = revision;
  }
  metrics().observe(Measure::kFrameEncodeSeconds, seconds);
  metrics().observe(Measure::kFrameBytes, static_cast<double>(frame.data.size()));
  wishes_->note_encoder_bytes(encoder_.byte_count());
  {
    const std::lock_guard lock(mutex_);
    encoder_bytes_ = encoder_.byte_count();
    if (!closed_) frame_ = std::move(frame);
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
    } else if (farewell_ && unanswered_ == 0) {
      message = *std::exchange(farewell_, std::nullopt);
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
  return closed_ && answers_.empty() && unanswered_ == 0 && !farewell_;
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
