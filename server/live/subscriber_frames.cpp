// The part of a subscriber for its pages and frames.

#include <algorithm>

#include "server/live/subscriber.h"
#include "server/metrics/metrics.h"

namespace burnish {

using std::chrono::steady_clock;

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

void Subscriber::set_layer(bool is_there) {
  if (wishes_->set_layer(is_there)) post_pages();
}

static GoAway go_away_of(const char* task, const Status& why) {
  GoAwayCode code = GoAwayCode::kFailed;
  if (why.code() == StatusCode::kResourceExhausted) code = GoAwayCode::kTooManyPages;
  if (why.code() == StatusCode::kDataLoss) code = GoAwayCode::kDamagedPages;
  return {code, "the server cannot " + std::string(task) + ": " + why.message(), true};
}

// Weak: nobody needs the pages of a client that has gone.
void Subscriber::post_pages() {
  const auto fail = [](Subscriber& self, const Status& why) {
    self.close(go_away_of("show the pages", why));
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

// A frame that touches few pages must not round the others anew, so after an exact frame the finest
// step is tried first.
static StepChoice steps_of(bool is_still, bool last_was_exact, uint32_t bytes_max) {
  if (is_still) return kStillSteps;
  StepChoice steps = moving_steps(bytes_max == 0 ? SIZE_MAX : bytes_max);
  if (last_was_exact) steps.finest = 0;
  return steps;
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

void Subscriber::show(FrameSnapshot snapshot) {
  {
    const std::lock_guard lock(mutex_);
    if (closed_ || credits_ == 0 || making_frame_ || shown_version_ > snapshot.version) return;
    --credits_;
    making_frame_ = true;
    key_frame_allowed_ = false;
    shown_version_ = snapshot.version;
    shown_revision_ = snapshot.pages->shown.revision();
    shown_settled_ = snapshot.stats.settled;
    snapshot.stats.client_time_us = client_time_us_;
    frame_beat_ = last_beat_;
  }
  const auto self = shared_from_this();
  encoders_.post(
      {.work = [self, snapshot = std::move(snapshot)] { self->encode(snapshot); },
       .on_failure = [self](const Status& why) { self->close(go_away_of("make a frame", why)); }});
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

EncodedPageFrame Subscriber::encode(const FrameSnapshot& snapshot, uint32_t bytes_max) {
  const std::vector<WantedPage> wanted = snapshot.surface->wanted(*snapshot.pages);
  EncodedPageFrame frame =
      encoder_.encode({snapshot.pages->shown, wanted, snapshot.surface->largest_move()},
                      steps_of(snapshot.is_still, last_was_exact_, bytes_max));
  last_was_exact_ = frame.step_shift == 0;
  return frame;
}

bool Subscriber::shows_the_last(const EncodedPageFrame& frame, uint32_t revision) const {
  return frame.sent_pages == 0 && frame.sent_gains == 0 && frame.sent_held == 0 &&
         revision == last_revision_ && frame.reference != 0 && frame.reference == last_sequence_;
}

void Subscriber::encode(const FrameSnapshot& snapshot) {
  FrameCredit unseen;
  {
    const std::lock_guard lock(mutex_);
    std::swap(unseen, unseen_);
    unseen_.frame_bytes = unseen.frame_bytes;  // stays until the next credit
  }
  const auto start = steady_clock::now();
  begin_kind(snapshot.pages->kind);
  hear(unseen);
  const EncodedPageFrame encoded = encode(snapshot, unseen.frame_bytes);
  const double seconds = std::chrono::duration<double>(steady_clock::now() - start).count();
  LiveFrame frame{{}, snapshot.stats};
  frame.stats.encode_ms = seconds * 1e3;
  const uint32_t revision = snapshot.pages->shown.revision();
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

}  // namespace burnish
