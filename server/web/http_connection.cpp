// Requests of HTTP: TLS, the rules for Host and Origin, the page's files, the way to a WebSocket.

#include <chrono>
#include <optional>

#include <boost/asio/any_io_executor.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/ssl/stream_base.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/http/parser.hpp>
#include <boost/beast/http/read.hpp>
#include <boost/beast/http/span_body.hpp>
#include <boost/beast/http/write.hpp>
#include <boost/beast/websocket/rfc6455.hpp>

#include "server/web/gateway_state.h"
#include "server/web/page_answer.h"
#include "server/web/protocol/web_limits.h"
#include "server/web/tls_contexts.h"

namespace burnish {
namespace {

namespace http = beast::http;
using std::chrono::steady_clock;

std::string_view text_of(beast::string_view text) {
  return {text.data(), text.size()};
}

bool offers_protocol(const HttpRequest& request) {
  return http::token_list(request[http::field::sec_websocket_protocol]).exists("burnish.v1");
}

template <typename Stream>
class HttpConnection final : public WebConnection,
                             public std::enable_shared_from_this<HttpConnection<Stream>> {
 public:
  HttpConnection(GatewayState& gateway, WebPeer peer, Stream stream)
      : slot_(gateway.connections),
        gateway_(gateway),
        peer_(std::move(peer)),
        strand_(stream.get_executor()),
        stream_(std::move(stream)),
        timer_(strand_) {}

  void start() {
    slot_.take(this->weak_from_this());
    on_strand([](HttpConnection& self) { self.secure(); });
  }

  // A page's request is short. So there is nothing to wait for.
  void leave() override { close(); }
  void close() override {
    on_strand([](HttpConnection& self) { self.end(); });
  }

 private:
  using Answer = http::response<http::span_body<const char>>;

  template <typename What>
  void on_strand(What what) {
    asio::post(strand_, [self = this->shared_from_this(), what] { what(*self); });
  }

  void secure() {
    set_timer(kWebHandshakeTimeMax);
    if constexpr (std::is_same_v<Stream, TlsStream>) {
      stream_.async_handshake(
          asio::ssl::stream_base::server,
          [self = this->shared_from_this()](StreamError error) { self->take_handshake(error); });
    } else {
      read();
    }
  }

  void take_handshake(StreamError error) {
    if constexpr (std::is_same_v<Stream, TlsStream>) {
      if (error) {
        report_web_refusal(Refusal::kHandshake, peer_, "TLS failed: " + error.message());
        return end();
      }
      peer_.certificate = certificate_name(stream_.native_handle());
      read();
    }
  }

  void read() {
    if (is_ended_) return;
    parser_.emplace();
    parser_->header_limit(kWebHeaderBytesMax);
    http::async_read_header(stream_, buffer_, *parser_,
                            [self = this->shared_from_this()](StreamError error, size_t) {
                              self->take_request(error);
                            });
  }

  void take_request(StreamError error) {
    if (is_ended_) return;
    if (error == http::error::header_limit)
      return refuse(431, Refusal::kMalformed,
                    "headers of more than " + std::to_string(kWebHeaderBytesMax) + " bytes");
    if (error.category() == http::make_error_code(http::error::end_of_stream).category() &&
        error != http::error::end_of_stream)
      return refuse(400, Refusal::kMalformed, "not a request of HTTP: " + error.message());
    if (error) return end();
    const HttpRequest& request = parser_->get();
    const Status host =
        check_host(gateway_.rules, text_of(request[http::field::host]), peer_.local_address);
    if (!host.is_ok()) return refuse(403, Refusal::kHost, host.message());
    if (!parser_->is_done()) return refuse(413, Refusal::kMalformed, "a request has a body");
    if (is_for_calls(text_of(request.target()))) return open_socket(request);
    send(answer_page(gateway_.files, {text_of(request.method_string()), text_of(request.target()),
                                      text_of(request[http::field::if_none_match]),
                                      text_of(request[http::field::accept_encoding])}));
  }

  void open_socket(const HttpRequest& request) {
    const Status origin = check_origin(gateway_.rules, text_of(request[http::field::origin]),
                                       text_of(request[http::field::host]));
    if (!origin.is_ok()) return refuse(403, Refusal::kOrigin, origin.message());
    if (!beast::websocket::is_upgrade(request))
      return refuse(426, Refusal::kMalformed, "/rpc takes a WebSocket alone");
    if (!offers_protocol(request))
      return refuse(400, Refusal::kMalformed, "the subprotocol is not burnish.v1");
    timer_.cancel();
    is_ended_ = true;
    serve_socket(gateway_, std::move(peer_), std::move(stream_), parser_->release());
  }

  /// Answers and ends the connection.
  void refuse(unsigned status, Refusal reason, const std::string& why) {
    report_web_refusal(reason, peer_, why);
    refusal_ = why + "\n";
    keeps_alive_ = false;
    send(refuse_page(status, refusal_));
  }

  void send(const PageAnswer& page) {
    set_timer(kWebSilenceMax);
    const HttpRequest& request = parser_->get();
    const bool is_head = request.method() == http::verb::head;
    answer_.emplace();
    answer_->version(11);
    answer_->result(page.status);
    for (const auto& [name, value] : page.headers) answer_->set(name, value);
    if (!is_head) answer_->body() = {page.body.data(), page.body.size()};
    if (page.status != 304) answer_->content_length(page.body.size());
    answer_->keep_alive(keeps_alive_ && request.keep_alive());
    http::async_write(
        stream_, *answer_,
        [self = this->shared_from_this()](StreamError error, size_t) { self->take_sent(error); });
  }

  void take_sent(StreamError error) {
    if (error || !answer_->keep_alive()) return end();
    set_timer(kWebSilenceMax);
    read();
  }

  void set_timer(steady_clock::duration time) {
    timer_.expires_after(time);
    timer_.async_wait([self = this->shared_from_this()](StreamError error) {
      if (!error && self->timer_.expiry() <= steady_clock::now()) self->end();
    });
  }

  void end() {
    if (is_ended_) return;
    is_ended_ = true;
    timer_.cancel();
    StreamError ignored;
    socket_of(stream_).shutdown(PlainStream::shutdown_both, ignored);
    socket_of(stream_).close(ignored);
  }

  WebConnections::Slot slot_;  // first, so that it goes last: then the gateway may go
  GatewayState& gateway_;
  WebPeer peer_;
  const asio::any_io_executor strand_;
  Stream stream_;
  asio::steady_timer timer_;
  beast::flat_buffer buffer_{2 * kWebHeaderBytesMax};
  std::optional<http::request_parser<http::empty_body>> parser_;
  std::optional<Answer> answer_;
  std::string refusal_;
  bool keeps_alive_ = true;
  bool is_ended_ = false;
};

}  // namespace

void serve_http(GatewayState& gateway, WebPeer peer, PlainStream stream) {
  std::make_shared<HttpConnection<PlainStream>>(gateway, std::move(peer), std::move(stream))
      ->start();
}

void serve_http(GatewayState& gateway, WebPeer peer, TlsStream stream) {
  std::make_shared<HttpConnection<TlsStream>>(gateway, std::move(peer), std::move(stream))->start();
}

}  // namespace burnish
