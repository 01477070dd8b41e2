#include "server/web/web_gateway.h"

#include <algorithm>
#include <thread>

#include <boost/asio/executor_work_guard.hpp>
#include <spdlog/spdlog.h>

#include "server/process/line_limiter.h"
#include "server/web/gateway_state.h"
#include "server/web/tls_contexts.h"

namespace burnish {

static constexpr unsigned kThreadsMax = 4;

struct WebGateway::State {
  State(WebGatewayOptions options, WebCalls calls)
      : gateway{{std::move(options.hosts), options.certificates != nullptr},
                std::move(calls),
                WebFiles(),
                {}} {
    for (std::string& name : names_of_this_machine())
      gateway.rules.hosts.push_back(std::move(name));
    if (options.certificates)
      tls =
          std::make_unique<TlsContexts>(*options.certificates, options.client_certificate_required);
    const unsigned count = std::clamp(std::thread::hardware_concurrency(), 1u, kThreadsMax);
    for (unsigned i = 0; i < count; ++i) threads.emplace_back([this] { run(); });
  }

  /// A client must not end the server, whatever Boost throws.
  void run() {
    for (;;) {
      try {
        io.run();
        return;
      } catch (const std::exception& error) {
        spdlog::error("the web gateway lost a connection: {}", error.what());
      }
    }
  }

  GatewayState gateway;
  std::unique_ptr<TlsContexts> tls;
  asio::io_context io;
  asio::executor_work_guard<asio::io_context::executor_type> work{io.get_executor()};
  std::vector<std::thread> threads;
};

/// Returns the numeric address without port that the client has connected to.
static std::string local_address_of(const PlainStream& socket) {
  StreamError error;
  const auto address = socket.local_endpoint(error).address();
  if (error) return {};
  if (address.is_v6() && address.to_v6().is_v4_mapped())
    return asio::ip::make_address_v4(asio::ip::v4_mapped, address.to_v6()).to_string();
  return address.to_string();
}

static bool is_ipv6(int fd) {
  sockaddr_storage address = {};
  socklen_t length = sizeof(address);
  getsockname(fd, reinterpret_cast<sockaddr*>(&address), &length);
  return address.ss_family == AF_INET6;
}

WebGateway::WebGateway(WebGatewayOptions options, WebCalls calls)
    : state_(std::make_unique<State>(std::move(options), std::move(calls))) {}

WebGateway::~WebGateway() {
  close();
}

void WebGateway::take(int fd, const std::string& peer) {
  PlainStream socket(asio::make_strand(state_->io));
  StreamError error;
  socket.assign(is_ipv6(fd) ? asio::ip::tcp::v6() : asio::ip::tcp::v4(), fd, error);
  if (error) {
    ::close(fd);
    return;
  }
  WebPeer client{peer, local_address_of(socket), {}};
  if (!state_->tls) return serve_http(state_->gateway, std::move(client), std::move(socket));
  const auto context = state_->tls->current();
  if (!context.is_ok()) {
    spdlog::error("refused {}: {}", peer, context.status().message());
    return;
  }
  serve_http(state_->gateway, std::move(client), TlsStream(std::move(socket), **context));
}

size_t WebGateway::connections() const {
  return state_->gateway.connections.count();
}

void WebGateway::leave() {
  state_->gateway.connections.leave();
}

void WebGateway::close() {
  if (state_->threads.empty()) return;
  state_->gateway.connections.close();
  state_->gateway.connections.wait_until_empty();
  state_->work.reset();
  for (std::thread& thread : state_->threads) thread.join();
  state_->threads.clear();
}

void report_web_refusal(Refusal reason, const WebPeer& peer, std::string_view why) {
  metrics().count_refusal(reason);
  if (may_log(LineKind::kConnection)) spdlog::warn("web: refused {}: {}", peer.name, why);
}

}  // namespace burnish
