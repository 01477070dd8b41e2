#pragma once

#include <memory>
#include <optional>
#include <string>

#include "tests/system/server_process.h"
#include "tests/system/wire_call.h"

namespace burnish {

inline constexpr char kListScansRpc[] = "/burnish.v1.Library/ListScans";
inline constexpr char kImportRpc[] = "/burnish.v1.Library/Import";
inline constexpr char kEditRpc[] = "/burnish.v1.Editing/Edit";
inline constexpr char kExportRpc[] = "/burnish.v1.Editing/Export";

/// How a test opens a WebSocket.
struct WebClientOptions {
  std::string ca = {};                     ///< PEM; empty: plain text
  std::string certificate = {}, key = {};  ///< of the client, PEM; empty: none
  std::string host = {};                   ///< the header Host; empty: the address
  std::string origin = {};                 ///< empty: none, as clients that are not browsers
  std::string target = "/rpc";
  std::string protocol = "burnish.v1";
  int receive_buffer_bytes = 0;  ///< of the kernel; 0: its default
};

/// A client of the web gateway. Its functions wait.
class WebClient {
 public:
  struct Frame {
    bool is_text;
    std::string bytes;
  };

  /// `address` is HOST:PORT with a numeric host. Check is_open() afterwards.
  explicit WebClient(const std::string& address, const WebClientOptions& options = {});
  ~WebClient();

  bool is_open() const;

  /// Return whether the frame went out.
  bool send_text(const std::string& text);
  bool send_message(const std::string& bytes);
  bool send_part(const std::string& bytes);  ///< of a message that goes on

  /// Returns the next frame; nothing once the gateway has closed the socket.
  std::optional<Frame> read();

  int close_code() const;  ///< after read() returned nothing; 0 without a close frame

  /// Says goodbye and waits for the answer.
  void close();

  /// Breaks the connection without a word.
  void break_off();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Makes a call over the socket, as call() does over a channel. Where the gateway has no answer,
/// the status is UNKNOWN.
WireAnswer call(WebClient& client, const WireCall& wire);

/// Returns the text frame that begins a call.
std::string begin_of(const std::string& method, const std::string& token = {});

/// Reads to the end of the call that runs. Adds its messages to the answer.
WireAnswer read_to_end(WebClient& client);

/// Returns HOST:PORT of the server's web gateway. Needs: its flags have --web.
std::string web_address(const ServerProcess& server);

/// Asks for a WebSocket in plain text and returns the status of HTTP: 101 if the gateway opens it.
int upgrade_status(const std::string& address, const WebClientOptions& options);

/// Sends `request` as it is to HOST:PORT and returns all until the server closes or `enough` bytes
/// are there.
std::string http_exchange(const std::string& address, const std::string& request,
                          size_t enough = SIZE_MAX);

}  // namespace burnish
