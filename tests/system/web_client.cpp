#include "tests/system/web_client.h"

#include <unistd.h>
#include <utility>  // Boost 1.74 uses std::exchange without it
#include <variant>

#include <arpa/inet.h>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/ssl/context.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/ssl/ssl_stream.hpp>
#include <boost/beast/websocket/ssl.hpp>
#include <boost/beast/websocket/stream.hpp>
#include <netinet/in.h>
#include <nlohmann/json.hpp>
#include <sys/socket.h>

#include "common/base/check.h"

namespace burnish {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace websocket = beast::websocket;
using Plain = websocket::stream<asio::ip::tcp::socket, false>;
using Secure = websocket::stream<beast::ssl_stream<asio::ip::tcp::socket>, false>;
using Error = boost::system::error_code;

sockaddr_in address_of(const std::string& text) {
  const size_t colon = text.rfind(':');
  sockaddr_in address = {};
  address.sin_family = AF_INET;
  address.sin_port = htons(static_cast<uint16_t>(std::stoi(text.substr(colon + 1))));
  BURNISH_CHECK(inet_pton(AF_INET, text.substr(0, colon).c_str(), &address.sin_addr) == 1, text);
  return address;
}

int connected_socket(const std::string& text, int receive_buffer_bytes = 0) {
  const sockaddr_in address = address_of(text);
  const int fd = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  if (receive_buffer_bytes > 0)
    setsockopt(fd, SOL_SOCKET, SO_RCVBUF, &receive_buffer_bytes, sizeof(receive_buffer_bytes));
  if (connect(fd, reinterpret_cast<const sockaddr*>(&address), sizeof(address)) == 0) return fd;
  ::close(fd);
  return -1;
}

}  // namespace

struct WebClient::State {
  asio::io_context io;
  asio::ssl::context tls{asio::ssl::context::tls_client};
  std::variant<std::monostate, Plain, Secure> socket;
  bool is_open = false;
  int close_code = 0;

  asio::ip::tcp::socket& lowest() {
    if (auto* plain = std::get_if<Plain>(&socket)) return plain->next_layer();
    return std::get<Secure>(socket).next_layer().next_layer();
  }

  template <typename What>
  auto with_socket(What what) {
    if (auto* plain = std::get_if<Plain>(&socket)) return what(*plain);
    return what(std::get<Secure>(socket));
  }

  void connect(const std::string& address, const WebClientOptions& options) {
    const int fd = connected_socket(address, options.receive_buffer_bytes);
    if (fd < 0) return;
    asio::ip::tcp::socket tcp(io);
    tcp.assign(asio::ip::tcp::v4(), fd);
    tcp.set_option(asio::ip::tcp::no_delay(true));
    if (options.ca.empty()) {
      socket.emplace<Plain>(std::move(tcp));
    } else {
      tls.set_verify_mode(asio::ssl::verify_peer);
      tls.add_certificate_authority(asio::buffer(options.ca));
      if (!options.key.empty()) {
        tls.use_certificate_chain(asio::buffer(options.certificate));
        tls.use_private_key(asio::buffer(options.key), asio::ssl::context::pem);
      }
      auto& secure = socket.emplace<Secure>(std::move(tcp), tls);
      Error error;
      secure.next_layer().handshake(asio::ssl::stream_base::client, error);
      if (error) return;
    }
    upgrade(options.host.empty() ? address : options.host, options);
  }

  void upgrade(const std::string& host, const WebClientOptions& options) {
    with_socket([&](auto& s) {
      s.auto_fragment(false);
      s.read_message_max(0);
      s.set_option(websocket::stream_base::decorator([&](websocket::request_type& request) {
        if (!options.protocol.empty())
          request.set(beast::http::field::sec_websocket_protocol, options.protocol);
        if (!options.origin.empty()) request.set(beast::http::field::origin, options.origin);
      }));
      Error error;
      s.handshake(host, options.target, error);
      is_open = !error;
    });
  }
};

WebClient::WebClient(const std::string& address, const WebClientOptions& options)
    : state_(std::make_unique<State>()) {
  state_->connect(address, options);
}

WebClient::~WebClient() = default;

bool WebClient::is_open() const {
  return state_->is_open;
}
int WebClient::close_code() const {
  return state_->close_code;
}

bool WebClient::send_text(const std::string& text) {
  return state_->with_socket([&](auto& socket) {
    Error error;
    socket.text(true);
    socket.write(asio::buffer(text), error);
    return !error;
  });
}

bool WebClient::send_message(const std::string& bytes) {
  return state_->with_socket([&](auto& socket) {
    Error error;
    socket.binary(true);
    socket.write(asio::buffer(bytes), error);
    return !error;
  });
}

bool WebClient::send_part(const std::string& bytes) {
  return state_->with_socket([&](auto& socket) {
    Error error;
    socket.binary(true);
    socket.write_some(false, asio::buffer(bytes), error);
    return !error;
  });
}

std::optional<WebClient::Frame> WebClient::read() {
  return state_->with_socket([&](auto& socket) -> std::optional<Frame> {
    beast::flat_buffer buffer;
    Error error;
    socket.read(buffer, error);
    if (error) {
      state_->is_open = false;
      state_->close_code = error == websocket::error::closed ? socket.reason().code : 0;
      return std::nullopt;
    }
    const auto data = buffer.cdata();
    return Frame{socket.got_text(), {static_cast<const char*>(data.data()), data.size()}};
  });
}

void WebClient::close() {
  state_->with_socket([&](auto& socket) {
    Error ignored;
    socket.close(websocket::close_code::normal, ignored);
  });
}

void WebClient::break_off() {
  Error ignored;
  state_->lowest().close(ignored);
}

std::string begin_of(const std::string& method, const std::string& token) {
  nlohmann::json frame = {{"call", method.substr(1)}};
  if (!token.empty()) frame["token"] = token;
  return frame.dump();
}

WireAnswer read_to_end(WebClient& client) {
  WireAnswer answer;
  while (auto frame = client.read()) {
    if (!frame->is_text) {
      answer.messages.push_back(std::move(frame->bytes));
      continue;
    }
    const auto end = nlohmann::json::parse(frame->bytes);
    answer.status = {end["code"].get<grpc::StatusCode>(), end["message"].get<std::string>()};
    return answer;
  }
  answer.status = {grpc::StatusCode::UNKNOWN, "the socket is closed"};
  return answer;
}

WireAnswer call(WebClient& client, const WireCall& wire) {
  client.send_text(begin_of(wire.method, wire.token));
  for (const std::string& message : wire.messages) client.send_message(message);
  if (wire.cancel) client.send_text(R"({"cancel":true})");
  if (!wire.keep_open && !wire.cancel) client.send_text(R"({"end":true})");
  if (wire.enough_messages == 0) return read_to_end(client);
  WireAnswer answer;
  while (answer.messages.size() < wire.enough_messages) {
    auto frame = client.read();
    if (!frame || frame->is_text) return answer;
    answer.messages.push_back(std::move(frame->bytes));
  }
  client.send_text(R"({"cancel":true})");
  const WireAnswer rest = read_to_end(client);
  if (rest.status.error_code() != grpc::StatusCode::CANCELLED) answer.status = rest.status;
  return answer;
}

std::string web_address(const ServerProcess& server) {
  const std::string address = server.announced("web on ");
  return address.substr(address.find("//") + 2);
}

std::string http_exchange(const std::string& address, const std::string& request, size_t enough) {
  const int fd = connected_socket(address);
  (void)!::write(fd, request.data(), request.size());
  std::string answer;
  char piece[4096];
  for (ssize_t size; answer.size() < enough && (size = ::read(fd, piece, sizeof(piece))) > 0;)
    answer.append(piece, static_cast<size_t>(size));
  ::close(fd);
  return answer;
}

int upgrade_status(const std::string& address, const WebClientOptions& options) {
  std::string request = "GET " + options.target +
                        " HTTP/1.1\r\nHost: " + (options.host.empty() ? address : options.host) +
                        "\r\nConnection: Upgrade\r\nUpgrade: websocket\r\n"
                        "Sec-WebSocket-Version: 13\r\n"
                        "Sec-WebSocket-Key: AAAAAAAAAAAAAAAAAAAAAA==\r\n";
  if (!options.protocol.empty()) request += "Sec-WebSocket-Protocol: " + options.protocol + "\r\n";
  if (!options.origin.empty()) request += "Origin: " + options.origin + "\r\n";
  const std::string answer = http_exchange(address, request + "\r\n", 12);
  return std::stoi("0" + answer.substr(std::min<size_t>(answer.size(), 9), 3));
}

}  // namespace burnish
