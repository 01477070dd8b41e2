#pragma once

#include <chrono>
#include <cstddef>

namespace burnish {

/// Limits of the web gateway. docs/web.md lists them for writers of clients.
inline constexpr size_t kWebMessageBytesMax = size_t{16} << 20;  // of a binary frame, as for gRPC
inline constexpr size_t kWebOpenMessageBytesMax = 512;  // of a call that is open to strangers
inline constexpr size_t kWebUnfinishedBytesMax = size_t{128} << 20;  // of all sockets together
inline constexpr size_t kWebControlBytesMax = 8192;                  // of a text frame
inline constexpr size_t kWebHeaderBytesMax = 8192;                   // of a request of HTTP
inline constexpr size_t kWebTokenBytesMax = 1024;
inline constexpr std::chrono::seconds kWebHandshakeTimeMax{10};  // TLS, then a request's headers
inline constexpr std::chrono::seconds kWebSilenceMax{30};        // of a client's end of a socket
inline constexpr std::chrono::seconds kWebPingInterval{10};
inline constexpr std::chrono::seconds kWebCloseTimeMax{2};  // for the answer to a close frame

}  // namespace burnish
