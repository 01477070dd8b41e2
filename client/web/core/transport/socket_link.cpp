#include "client/web/core/transport/socket_link.h"

#include <algorithm>
#include <utility>

#include "client/connection/connection_state.h"
#include "client/web/core/host/imports.h"
#include "common/wire/live_wire.h"

namespace burnish {

// More than one message on the way to the link holds up newer ones of more use.
static constexpr size_t kUnsentBytesMax = 64 << 10;

SocketLink::SocketLink(std::shared_ptr<ServerRoute> route, LiveOptions options)
    : route_(std::move(route)),
      clock_(options.clock),
      on_news_(options.on_news),
      conversation_(route_, std::move(options)),
      begins_at_(clock_()) {
  host_wake();
}

void SocketLink::begin_stream() {
  begins_at_.reset();
  conversation_.begin();
  stream_ = std::make_unique<HostCall>("burnish.v1.Editing/Edit", route_->place().node,
                                       [this] { listen(); });
  speak();
}

static Result<std::optional<ServerMessage>> parsed(const std::vector<uint8_t>& bytes) {
  v1::ServerMessage message;
  if (!message.ParseFromArray(bytes.data(), static_cast<int>(bytes.size())))
    return data_loss("a message of the server is damaged");
  return from_wire(std::move(message));
}

void SocketLink::listen() {
  while (const auto message = stream_->take()) conversation_.hear(parsed(*message));
  speak();
  on_news_();  // on_time() follows, which may end the stream: not within its own event
}

void SocketLink::speak() {
  if (!stream_ || stream_->end()) return;
  while (stream_->buffered() < kUnsentBytesMax) {
    const auto message = conversation_.next();
    if (!message) return;
    stream_->send(to_wire(*message).SerializeAsString());
  }
}

void SocketLink::leave_if_over(Time now) {
  if (!stream_) return;
  if (!stream_->end()) {
    if (conversation_.must_leave()) stream_->cancel();
    return;
  }
  const CallEnd end = *stream_->end();
  stream_.reset();
  const auto wait =
      conversation_.end(call_status(route_->address(), {end.code, end.message, end.details}));
  if (wait) begins_at_ = now + *wait;
  on_news_();
}

SocketLink::Time SocketLink::on_time(Time now) {
  leave_if_over(now);
  if (begins_at_ && *begins_at_ <= now) begin_stream();
  speak();
  if (begins_at_) return *begins_at_;
  return stream_ ? conversation_.next_deadline() : Time::max();
}

Status SocketLink::apply(std::vector<Edit> edits) {
  const Status taken = conversation_.apply(std::move(edits));
  speak();
  return taken;
}

void SocketLink::preview(const std::string& edit_id, PreviewChange change) {
  conversation_.preview(edit_id, std::move(change));
  speak();
}

void SocketLink::drop_preview(const std::string& edit_id) {
  conversation_.drop_preview(edit_id);
  speak();
}

void SocketLink::move_brush(const std::optional<BrushRing>& ring) {
  conversation_.move_brush(ring);
  speak();
}

Status SocketLink::show_pages(std::vector<std::shared_ptr<const Page>> added,
                              std::vector<PageId> removed) {
  const Status changed = conversation_.show_pages(added, removed);
  speak();
  return changed;
}

LiveNews SocketLink::take(bool draws) {
  LiveNews news = conversation_.take(draws);
  speak();
  return news;
}

void SocketLink::on_picture(std::chrono::microseconds took) {
  conversation_.on_picture(took);
}

}  // namespace burnish
