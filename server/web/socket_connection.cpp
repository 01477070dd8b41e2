// A WebSocket: the frames of a client to a call, and the call's messages to frames.

#include <chrono>
#include <deque>
#include <utility>

#include <boost/asio/any_io_executor.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/websocket/ssl.hpp>
#include <boost/beast/websocket/stream.hpp>

#include "server/trust/role.h"
#include "server/web/bridged_call.h"
#include "server/web/gateway_state.h"
#include "server/web/protocol/conversation.h"
#include "server/web/protocol/web_limits.h"

namespace burnish {
namespace {

namespace websocket = beast::websocket;
using Clock = std::chrono::steady_clock;

constexpr size_t kReadStepBytes = size_t{64} << 10;
constexpr size_t kKeptBufferBytes = size_t{1} << 20;

/// A frame that goes out.
struct Outgoing {
  bool is_text;
  std::vector<grpc::Slice> parts;

  std::vector<asio::const_buffer> buffers() const {
    std::vector<asio::const_buffer> all;
    for (const grpc::Slice& part : parts) all.emplace_back(part.begin(), part.size());
    return all;
  }
  size_t size() const { return asio::buffer_size(buffers()); }
};

template <typename Stream>
class SocketConnection final : public WebConnection,
                               public std::enable_shared_from_this<SocketConnection<Stream>> {
 public:
  SocketConnection(GatewayState& gateway, WebPeer peer, Stream stream)
      : slot_(gateway.connections),
        gateway_(gateway),
        peer_(std::move(peer)),
        strand_(stream.get_executor()),
        socket_(std::move(stream)),
        heart_(strand_),
        close_timer_(strand_) {}

  void start(HttpRequest request) {
    set_options();
    slot_.take(this->weak_from_this());
    beat();
    auto kept = std::make_shared<HttpRequest>(std::move(request));
    socket_.async_accept(*kept, [self = this->shared_from_this(), kept](StreamError error) {
      self->take_accepted(error);
    });
  }

  void leave() override {
    on_strand([](SocketConnection& self) {
      self.is_leaving_ = true;
      self.end_if_leaving();
    });
  }

  void close() override {
    on_strand([](SocketConnection& self) {
      self.close_with(CloseCode::kGoingAway, "the server is draining");
    });
  }

  ~SocketConnection() override { hold_unfinished(0); }

 private:
  template <typename What>
  void on_strand(What what) {
    asio::post(strand_, [self = this->shared_from_this(), what] { what(*self); });
  }

  void set_options() {
    socket_.set_option(websocket::stream_base::decorator([](websocket::response_type& answer) {
      answer.set(beast::http::field::sec_websocket_protocol, "burnish.v1");
    }));
    socket_.auto_fragment(false);
    socket_.read_message_max(0);  // counted here, so that a call ends with its own status
    socket_.control_callback(
        [this](websocket::frame_type, beast::string_view) { heard_ = Clock::now(); });
  }

  void take_accepted(StreamError error) {
    if (error) return fail();
    is_open_ = true;
    metrics().add(Count::kWebSockets, 1);
    end_if_leaving();
    read();
  }

  // ---- from the client

  /// Reads on where nothing waits: a message for the call, or the end of a call for the client.
  void read() {
    if (!is_open_ || is_reading_ || is_closing_ || is_passing_ || !outbox_is_free()) return;
    is_reading_ = true;
    heard_ = Clock::now();
    socket_.async_read_some(
        frame_, kReadStepBytes,
        [self = this->shared_from_this()](StreamError error, size_t) { self->take_read(error); });
  }

  /// A client that does not read its calls' ends is not read either.
  bool outbox_is_free() const { return call_ || outbox_.empty(); }

  void take_read(StreamError error) {
    is_reading_ = false;
    if (is_closing_) return;
    if (error) return fail();
    // Messages of strangers cost no memory.
    if (!socket_.got_text() && !conversation_.takes_messages()) frame_.consume(frame_.size());
    const size_t limit = socket_.got_text() ? kWebControlBytesMax : message_bytes_max_;
    const bool is_whole = socket_.is_message_done() || frame_.size() > limit;
    if (!hold_unfinished(is_whole ? 0 : frame_.size())) return obey(too_much_unfinished());
    if (is_whole) take_frame();
    read();
  }

  /// Counts what this socket holds of a message whose end has not come. Returns false where all
  /// sockets together would hold too much.
  bool hold_unfinished(size_t bytes) {
    const size_t before = std::exchange(unfinished_bytes_, bytes);
    const size_t of_all = gateway_.unfinished_bytes +=
        bytes - before;  // unsigned: wraps where less
    return bytes <= before || of_all <= kWebUnfinishedBytesMax;
  }

  static CloseSocket too_much_unfinished() {
    return {CloseCode::kTooBig, "all messages whose end has not come have more than " +
                                    std::to_string(kWebUnfinishedBytesMax) + " bytes"};
  }

  void take_frame() {
    metrics().add(Count::kWebReceivedBytes, frame_.size());
    const Order order = socket_.got_text()
                            ? conversation_.hear_text(frame_text())
                            : conversation_.hear_message(frame_.size(), message_bytes_max_);
    std::visit([this](const auto& what) { obey(what); }, order);
    frame_.consume(frame_.size());
    if (frame_.capacity() > kKeptBufferBytes) frame_ = beast::flat_buffer();
  }

  std::string_view frame_text() const {
    return {static_cast<const char*>(frame_.cdata().data()), frame_.size()};
  }

  void obey(const StartCall& order) {
    const std::string authorization =
        order.call.token.empty() ? std::string() : "Bearer " + order.call.token;
    const grpc::Status admitted =
        gateway_.calls.admit(order.call.method, {authorization, peer_.certificate}, peer_.name);
    if (!admitted.ok()) return end_call(admitted);
    const bool is_open = is_open_to_all(order.call.method);
    message_bytes_max_ = is_open ? kWebOpenMessageBytesMax : kWebMessageBytesMax;
    is_admitted_ |= !is_open;
    metrics().add(Count::kWebCalls, 1);
    call_ = std::make_shared<BridgedCall>(
        gateway_.calls, order.call.method,
        BridgedCall::Caller{authorization, order.call.user, peer_.name, peer_.certificate},
        events());
    call_->start();
  }

  void obey(const PassMessage&) {
    const grpc::Slice slice(frame_.cdata().data(), frame_.size());
    is_passing_ = call_->send(grpc::ByteBuffer(&slice, 1));
  }

  void obey(const EndMessages&) { call_->end_messages(); }
  void obey(const CancelCall&) { call_->cancel(); }
  void obey(const DropFrame&) {}

  void obey(const CloseSocket& order) {
    const bool is_too_big = order.code == CloseCode::kTooBig;
    report_web_refusal(is_too_big ? Refusal::kCutOff : Refusal::kMalformed, peer_, order.reason);
    if (conversation_.is_calling()) {
      const auto code =
          is_too_big ? grpc::StatusCode::RESOURCE_EXHAUSTED : grpc::StatusCode::INVALID_ARGUMENT;
      write_text(end_of_call_frame(code, order.reason));
    }
    close_with(order.code, order.reason);
  }

  // ---- from the call

  BridgedCall::Events events() {
    const auto self = this->shared_from_this();
    return {[self](std::function<void()> what) { asio::post(self->strand_, std::move(what)); },
            [self](grpc::ByteBuffer message) { self->take_message(message); },
            [self] {
              self->is_passing_ = false;
              self->read();
            },
            [self](const grpc::Status& status) { self->take_end(status); }};
  }

  void take_message(const grpc::ByteBuffer& message) {
    if (is_closing_) return call_->cancel();
    Outgoing frame{false, {}};
    if (!message.Dump(&frame.parts).ok()) return call_->cancel();
    write(std::move(frame));
  }

  void take_end(const grpc::Status& status) {
    call_.reset();
    if (!is_closing_) end_call(status);
  }

  void end_call(const grpc::Status& status) {
    conversation_.note_end();
    write_text(
        end_of_call_frame(status.error_code(), status.error_message(), status.error_details()));
  }

  // ---- to the client

  void write_text(const std::string& text) { write({true, {grpc::Slice(text)}}); }

  void write(Outgoing frame) {
    outbox_.push_back(std::move(frame));
    if (!is_writing_) write_next();
  }

  void write_next() {
    is_writing_ = true;
    const Outgoing& frame = outbox_.front();
    socket_.text(frame.is_text);
    socket_.async_write(frame.buffers(),
                        [self = this->shared_from_this()](StreamError error, size_t) {
                          self->take_written(error);
                        });
  }

  void take_written(StreamError error) {
    is_writing_ = false;
    const Outgoing frame = std::move(outbox_.front());
    outbox_.pop_front();
    if (error) return fail();
    metrics().add(Count::kWebSentBytes, frame.size());
    if (!outbox_.empty()) return write_next();
    if (is_closing_) return send_close();
    if (call_ && !frame.is_text) call_->read_next();
    end_if_leaving();
    read();
  }

  // ---- life and death

  /// Pings the client, and ends a connection that says nothing or makes no call.
  void beat() {
    heart_.expires_after(kWebPingInterval);
    heart_.async_wait([self = this->shared_from_this()](StreamError error) {
      if (!error && !self->is_closing_) self->take_beat();
    });
  }

  void take_beat() {
    const auto now = Clock::now();
    const bool is_silent = is_reading_ && now - heard_ > kWebSilenceMax;
    const bool is_idle_stranger = !is_admitted_ && now - opened_ > kWebSilenceMax;
    const bool is_slow_to_open = !is_open_ && now - opened_ > kWebHandshakeTimeMax;
    if (is_silent || is_idle_stranger || is_slow_to_open) {
      report_web_refusal(Refusal::kConnections, peer_,
                         is_silent ? "silent for too long" : "no call was admitted in time");
      return fail();
    }
    if (is_open_ && !is_pinging_) {
      is_pinging_ = true;
      socket_.async_ping({}, [self = this->shared_from_this()](StreamError ping_error) {
        self->is_pinging_ = false;
        if (ping_error) self->fail();
      });
    }
    beat();
  }

  void end_if_leaving() {
    if (is_leaving_ && !call_ && outbox_.empty())
      close_with(CloseCode::kGoingAway, "the server is draining");
  }

  /// Lets the frames that wait go out, then closes. Ends at once if the client does not play along.
  void close_with(CloseCode code, const std::string& reason) {
    if (is_closing_) return;
    is_closing_ = true;
    heart_.cancel();
    if (call_) call_->cancel();
    if (!is_open_) return break_off();
    close_reason_ = websocket::close_reason(static_cast<websocket::close_code>(code), reason);
    close_timer_.expires_after(kWebCloseTimeMax);
    close_timer_.async_wait([self = this->shared_from_this()](StreamError error) {
      if (!error) self->break_off();
    });
    if (!is_writing_) send_close();
  }

  void send_close() {
    if (!is_open_) return;
    is_open_ = false;
    socket_.async_close(close_reason_,
                        [self = this->shared_from_this()](StreamError) { self->break_off(); });
  }

  /// The connection is broken, or the client has closed it.
  void fail() {
    if (is_closing_) return break_off();
    is_closing_ = true;
    heart_.cancel();
    if (call_) call_->cancel();
    break_off();
  }

  void break_off() {
    is_open_ = false;
    close_timer_.cancel();
    StreamError ignored;
    socket_of(socket_.next_layer()).close(ignored);
  }

  WebConnections::Slot slot_;  // first, so that it goes last: then the gateway may go
  GatewayState& gateway_;
  const WebPeer peer_;
  const asio::any_io_executor strand_;
  websocket::stream<Stream, false> socket_;  // without compression
  asio::steady_timer heart_, close_timer_;
  beast::flat_buffer frame_;
  Conversation conversation_;
  std::shared_ptr<BridgedCall> call_;
  std::deque<Outgoing> outbox_;
  websocket::close_reason close_reason_;
  size_t message_bytes_max_ = kWebMessageBytesMax;
  size_t unfinished_bytes_ = 0;  // as the gateway counts them
  Clock::time_point opened_ = Clock::now(), heard_ = opened_;
  bool is_open_ = false;     // frames may go out
  bool is_reading_ = false;  // a read is under way
  bool is_passing_ = false;  // a message is on its way to the call
  bool is_writing_ = false;  // the first frame of the outbox goes out
  bool is_pinging_ = false;
  bool is_admitted_ = false;  // a call was let in that is not open to all
  bool is_leaving_ = false;   // closes after the call
  bool is_closing_ = false;
};

template <typename Stream>
void serve(GatewayState& gateway, WebPeer peer, Stream stream, HttpRequest request) {
  std::make_shared<SocketConnection<Stream>>(gateway, std::move(peer), std::move(stream))
      ->start(std::move(request));
}

}  // namespace

void serve_socket(GatewayState& gateway, WebPeer peer, PlainStream stream, HttpRequest request) {
  serve(gateway, std::move(peer), std::move(stream), std::move(request));
}

void serve_socket(GatewayState& gateway, WebPeer peer, TlsStream stream, HttpRequest request) {
  serve(gateway, std::move(peer), std::move(stream), std::move(request));
}

}  // namespace burnish
