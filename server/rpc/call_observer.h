#pragma once

#include <atomic>
#include <chrono>
#include <functional>
#include <memory>
#include <string>

#include <grpcpp/grpcpp.h>
#include <grpcpp/support/server_interceptor.h>

namespace burnish {

/// How many calls the server has let in. A call arrives with its headers; it starts once its first
/// message is whole, where it has exactly one.
struct CallCounts {
  std::atomic<uint64_t> arrived{0};
  std::atomic<uint64_t> started{0};
  std::atomic<int64_t> running{0};  ///< of our services: health and reflection may run for ever
};

/// Watches each call from its start to its end: counts it, gives it a request id, logs how it
/// ended, and gives a message that is none the status it deserves.
class CallObserverFactory final : public grpc::experimental::ServerInterceptorFactoryInterface {
 public:
  /// `on_call` hears the peer of each call, e.g. "ipv4:127.0.0.1:5000".
  CallObserverFactory(std::shared_ptr<CallCounts> counts,
                      std::function<void(const std::string& peer)> on_call)
      : counts_(std::move(counts)), on_call_(std::move(on_call)) {}

  grpc::experimental::Interceptor* CreateServerInterceptor(
      grpc::experimental::ServerRpcInfo* info) override;

 private:
  const std::shared_ptr<CallCounts> counts_;
  const std::function<void(const std::string& peer)> on_call_;
};

/// What the observer has written into a call's metadata: clients cannot, for it erases theirs.
std::string method_of(const grpc::CallbackServerContext& context);
std::string request_id_of(const grpc::CallbackServerContext& context);

}  // namespace burnish
