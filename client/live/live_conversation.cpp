#include "client/live/live_conversation.h"

#include <algorithm>

#include "common/base/limits.h"
#include "common/base/text.h"
#include "common/wire/edit_wire.h"

namespace burnish {

// Another try may cure these. The rest is about what was asked for, or who asked.
static bool is_worth_another_try(StatusCode code) {
  switch (code) {
    case StatusCode::kOk:
    case StatusCode::kUnavailable:
    case StatusCode::kCancelled:
    case StatusCode::kDeadlineExceeded:
    case StatusCode::kResourceExhausted:
    case StatusCode::kInternal:
      return true;
    default:
      return false;
  }
}

static Status check(const std::vector<Edit>& edits) {
  if (edits.empty() || edits.size() > kEditsPerFrameMax)
    return invalid_argument("1 to " + std::to_string(kEditsPerFrameMax) +
                            " edits go together, not " + std::to_string(edits.size()));
  for (const Edit& edit : edits) {
    RETURN_IF_ERROR(check_edit_id(edit.id));
    RETURN_IF_ERROR(validate(edit).with_context("edit " + edit.id));
    if (std::holds_alternative<SetCellFields>(edit.change))
      return invalid_argument("edit " + edit.id + ": cell fields are not for a live session");
  }
  return Status::ok();
}

LiveConversation::LiveConversation(std::shared_ptr<ServerRoute> route, LiveOptions options)
    : route_(std::move(route)),
      options_(std::move(options)),
      server_(route_->address()),
      receiver_({options_.head, options_.depth, options_.pages_fingerprint}),
      outbox_(options_.greeting, options_.head.page_count()),
      pacer_(options_.draw_interval) {}

Status LiveConversation::apply(std::vector<Edit> edits) {
  RETURN_IF_ERROR(check(edits));
  const LiveGuard lock(mutex_);
  if (news_.link == LinkState::kEnded) return failed_precondition("the session has ended");
  outbox_.apply(std::move(edits), options_.clock());
  return Status::ok();
}

void LiveConversation::preview(const std::string& edit_id, PreviewChange change) {
  const LiveGuard lock(mutex_);
  outbox_.preview(edit_id, std::move(change), options_.clock());
}

void LiveConversation::drop_preview(const std::string& edit_id) {
  const LiveGuard lock(mutex_);
  outbox_.drop_preview(edit_id);
}

void LiveConversation::move_brush(const std::optional<BrushRing>& ring) {
  const LiveGuard lock(mutex_);
  outbox_.move_brush(ring);
}

Status LiveConversation::show_pages(const std::vector<std::shared_ptr<const Page>>& added,
                                    const std::vector<PageId>& removed) {
  const LiveGuard lock(mutex_);
  return outbox_.pages().change(added, removed);
}

void LiveConversation::on_picture(std::chrono::microseconds took) {
  const LiveGuard lock(mutex_);
  pacer_.set_draw_interval(std::max(took, options_.draw_interval));
}

LiveNews LiveConversation::take(bool draws) {
  const Time now = options_.clock();
  LiveNews news;
  const LiveGuard lock(mutex_);
  if (draws) pacer_.on_drawn(now);
  if (draws && std::exchange(has_new_frame_, false))
    news_.stats.waited_ms = std::chrono::duration<double, std::milli>(now - last_decoded_).count();
  news.link = news_.link;
  news.stats = news_.stats;
  news.stats.frames_per_second = rate_.frames_per_second(now);
  news.stats.frame_bytes_max = budget_.bytes();
  news.stats.megabits_per_second = rate_.megabits_per_second(now);
  news.pages_refused = news_.pages_refused;
  news.unacknowledged = outbox_.unacknowledged();
  news.shows_previews = outbox_.has_said_previews() && shown_.shows_previews();
  news.events.swap(news_.events);
  news.frame = news_.frame;
  return news;
}

size_t LiveConversation::unacknowledged() const {
  const LiveGuard lock(mutex_);
  return outbox_.unacknowledged();
}

bool LiveConversation::has_ended() const {
  const LiveGuard lock(mutex_);
  return news_.link == LinkState::kEnded;
}

void LiveConversation::begin() {
  {
    const LiveGuard lock(mutex_);
    outbox_.restart();
    pacer_.restart();
    budget_.restart();
    shown_.restart();
  }
  receiver_.restart();
  server_ = route_->address();
  has_server_lost_it_ = false;
  last_heard_ = next_heartbeat_ = options_.clock();
}

bool LiveConversation::must_leave() {
  if (options_.clock() >= last_heard_ + options_.silence_max)
    go_away_ =
        "server " + server_ + ": nothing was heard for " + seconds_text(options_.silence_max);
  return !go_away_.empty() || !failure_.is_ok();
}

std::optional<ClientMessage> LiveConversation::next() {
  auto message = choose_message(options_.clock());
  // Lays out the pages of a change without the lock: callers do not wait for it.
  if (const auto* change = message ? std::get_if<ShowPages>(&*message) : nullptr)
    failure_ = receiver_.show(*change, std::exchange(added_pages_, {}));
  if (!failure_.is_ok()) return std::nullopt;
  return message;
}

std::optional<ClientMessage> LiveConversation::choose_message(Time now) {
  const LiveGuard lock(mutex_);
  const uint64_t previews = outbox_.previews_sent();
  if (auto message = outbox_.next()) {
    if (outbox_.previews_sent() > previews)
      shown_.preview_sent(outbox_.previews_sent(), outbox_.preview_since());
    if (const auto* change = std::get_if<ShowPages>(&*message))
      added_pages_ = outbox_.pages().find(change->added);
    return message;
  }
  const int due = pacer_.due(now);
  // One goes ahead of each credit: so the frame tells how long ago it was asked for.
  if (now >= next_heartbeat_ || (due > 0 && !beat_for_credit_)) {
    beat_for_credit_ = due > 0;
    return heartbeat(now);
  }
  if (due == 0 && !receiver_.has_answers()) return std::nullopt;
  FrameCredit credit = receiver_.take_answers();
  credit.frames = static_cast<uint32_t>(due);
  credit.frame_bytes = budget_.bytes();
  pacer_.granted(now, due);
  beat_for_credit_ = false;
  return credit;
}

Heartbeat LiveConversation::heartbeat(Time now) {
  const auto since = std::chrono::duration_cast<std::chrono::microseconds>(now.time_since_epoch());
  next_heartbeat_ = now + options_.heartbeat_interval;
  return {static_cast<uint64_t>(since.count())};
}

LiveConversation::Time LiveConversation::next_deadline() const {
  const LiveGuard lock(mutex_);
  return std::min({next_heartbeat_, last_heard_ + options_.silence_max, pacer_.next_due()});
}

Status LiveConversation::why_it_ended(const Status& of_stream) const {
  if (!failure_.is_ok()) return failure_;
  return go_away_.empty() ? of_stream : unavailable(go_away_);
}

std::optional<std::chrono::milliseconds> LiveConversation::end(const Status& of_stream) {
  const Status why = why_it_ended(of_stream);
  failure_ = Status::ok();
  go_away_.clear();
  const bool has_moved = !why.moved_to().empty();
  const bool is_over = !has_moved && !is_worth_another_try(why.code());
  {
    const LiveGuard lock(mutex_);
    const bool was_live = news_.link == LinkState::kLive;
    news_.pages_refused += was_live && why.code() == StatusCode::kResourceExhausted;
    if (is_over)
      news_.link = LinkState::kEnded;
    else if (news_.link != LinkState::kConnecting)
      news_.link = LinkState::kLost;
    tell(LinkChanged{news_.link, is_over ? why.to_string() : why.message(), has_moved});
    if (news_.stats.frames > frames_at_end_) failures_ = moves_ = 0;
    frames_at_end_ = news_.stats.frames;
  }
  if (is_over) return std::nullopt;
  if (has_moved) return follow(why);
  // The first failure may be a short one of the network.
  const bool is_gone = failures_ > 0 && why.code() == StatusCode::kUnavailable;
  if (is_gone || has_server_lost_it_) route_->give_up(server_);
  return retry_after();
}

// Servers that send a client in a circle wait for each other's leases.
std::chrono::milliseconds LiveConversation::follow(const Status& moved) {
  route_->move_to(ServerPlace::of(moved.moved_to()));
  return ++moves_ <= kMovesMax ? std::chrono::milliseconds(0) : retry_after();
}

// Clients of a server that has gone do not come back all at once.
std::chrono::milliseconds LiveConversation::retry_after() {
  const auto longest = std::min(options_.retry_after_max,
                                options_.retry_after_min * (1 << std::min(failures_++, 10)));
  return longest / 2 + longest * static_cast<int>(random_() % 100) / 200;
}

}  // namespace burnish
