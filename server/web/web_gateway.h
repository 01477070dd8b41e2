#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <grpcpp/grpcpp.h>

#include "server/trust/certificates.h"
#include "server/trust/guard.h"
#include "server/trust/reloaded.h"

namespace burnish {

struct WebGatewayOptions {
  std::vector<std::string> hosts;  ///< names of this server besides loopback and its address
  const Reloaded<Certificates>* certificates = nullptr;  ///< null: plain text
  bool client_certificate_required = true;               ///< if the certificates have a CA
};

/// The calls behind the gateway.
struct WebCalls {
  std::shared_ptr<grpc::Channel> channel;  ///< into this process
  /// Says whether a call may start, and logs and counts a refusal. Thread-safe.
  std::function<grpc::Status(const std::string& method, const Proof&, const std::string& peer)>
      admit;
  std::string secret;  ///< of the gateway's marks
};

/// Serves browsers: the page's files over HTTP, and gRPC's calls over WebSocket, as docs/web.md
/// says. Has its own threads. Thread-safe.
class WebGateway {
 public:
  /// Needs: the certificates outlive the gateway.
  WebGateway(WebGatewayOptions options, WebCalls calls);
  ~WebGateway();  ///< as close()

  /// Takes over a connected socket. `peer` is its name for the log.
  void take(int fd, const std::string& peer);

  /// Returns how many connections are open.
  size_t connections() const;

  /// Closes sockets without a call, others at the end of their call, with code 1001.
  void leave();

  /// Closes all sockets with code 1001, cancels their calls and waits for their end. Idempotent.
  /// Needs: take() is not called any more.
  void close();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace burnish
