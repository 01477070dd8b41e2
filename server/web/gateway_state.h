#pragma once

#include <atomic>
#include <memory>
#include <string>
#include <string_view>

#include <boost/beast/http/empty_body.hpp>
#include <boost/beast/http/message.hpp>

#include "server/metrics/metrics.h"
#include "server/web/protocol/request_rules.h"
#include "server/web/streams.h"
#include "server/web/web_connection.h"
#include "server/web/web_files.h"
#include "server/web/web_gateway.h"

namespace burnish {

/// The state that all connections of the gateway share. It outlives them.
struct GatewayState {
  RequestRules rules;
  WebCalls calls;
  WebFiles files;
  WebConnections connections;
  std::atomic<size_t> unfinished_bytes{0};  ///< of messages whose end has not come
};

/// The other end of a connection.
struct WebPeer {
  std::string name;           ///< for the log: "ipv4:127.0.0.1:5000"
  std::string local_address;  ///< that it has connected to
  std::string certificate;    ///< common name of its verified certificate; empty for none
};

using HttpRequest = beast::http::request<beast::http::empty_body>;

/// Serves requests of HTTP on a connected stream, until its end or until it becomes a WebSocket.
void serve_http(GatewayState& gateway, WebPeer peer, PlainStream stream);
void serve_http(GatewayState& gateway, WebPeer peer, TlsStream stream);

/// Serves calls on a stream whose client has asked for a WebSocket with `request`.
void serve_socket(GatewayState& gateway, WebPeer peer, PlainStream stream, HttpRequest request);
void serve_socket(GatewayState& gateway, WebPeer peer, TlsStream stream, HttpRequest request);

/// Logs and counts a refusal. `why` has no token.
void report_web_refusal(Refusal reason, const WebPeer& peer, std::string_view why);

}  // namespace burnish
