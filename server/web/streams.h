#pragma once

#include <utility>  // Boost 1.74 uses std::exchange without it

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/strand.hpp>
#include <boost/beast/ssl/ssl_stream.hpp>

namespace burnish {

namespace asio = boost::asio;
namespace beast = boost::beast;

/// The two kinds of streams below HTTP. Each has a strand: its handlers run one after the other.
using PlainStream = asio::ip::tcp::socket;
using TlsStream = beast::ssl_stream<PlainStream>;
using StreamError = boost::system::error_code;

inline PlainStream& socket_of(PlainStream& stream) {
  return stream;
}
inline PlainStream& socket_of(TlsStream& stream) {
  return stream.next_layer();
}

}  // namespace burnish
