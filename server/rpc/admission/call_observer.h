#pragma once

#include <atomic>
#include <chrono>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include <grpcpp/grpcpp.h>
#include <grpcpp/support/server_interceptor.h>

namespace burnish {

/// The number of calls that the server has let in. A call arrives with its headers. A call with
/// exactly one message starts when that message is whole.
struct CallCounts {
  std::atomic<uint64_t> arrived{0};
  std::atomic<uint64_t> started{0};
  std::atomic<int64_t> running{0};  ///< without health and reflection, which may run for ever
};

/// Watches each call from its start to its end. Counts it, gives it a request id, logs its end, and
/// gives a malformed message its proper status.
class CallObserverFactory final : public grpc::experimental::ServerInterceptorFactoryInterface {
 public:
  /// `on_call` gets the peer of each call that is not open to all, e.g. "ipv4:127.0.0.1:5000".
  /// Calls that have the web
  /// gateway's secret have the peer and the certificate that the gateway tells.
  CallObserverFactory(std::shared_ptr<CallCounts> counts, std::string gateway_secret,
                      std::function<void(const std::string& peer)> on_call)
      : counts_(std::move(counts)),
        gateway_secret_(std::make_shared<const std::string>(std::move(gateway_secret))),
        on_call_(std::move(on_call)) {}

  grpc::experimental::Interceptor* CreateServerInterceptor(
      grpc::experimental::ServerRpcInfo* info) override;

 private:
  const std::shared_ptr<CallCounts> counts_;
  const std::shared_ptr<const std::string> gateway_secret_;
  const std::function<void(const std::string& peer)> on_call_;
};

/// Read the observer's entries in a call's metadata. Clients cannot forge them: the observer erases
/// theirs.
std::string method_of(const grpc::CallbackServerContext& context);
std::string request_id_of(const grpc::CallbackServerContext& context);
std::string peer_of(const grpc::CallbackServerContext& context);

/// Returns the common name that the web gateway has verified; empty for none, and without the
/// gateway. The text lives as long as the call.
std::string_view gateway_certificate_of(const grpc::CallbackServerContext& context);

}  // namespace burnish
