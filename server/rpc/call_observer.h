#pragma once

#include <atomic>
#include <chrono>
#include <memory>
#include <string>

#include <grpcpp/grpcpp.h>
#include <grpcpp/support/server_interceptor.h>

#include "server/metrics/live_objects.h"

namespace burnish {

/// How many calls the server has seen. A call arrives with its headers; it starts once its first
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
  explicit CallObserverFactory(std::shared_ptr<CallCounts> counts) : counts_(std::move(counts)) {}

  grpc::experimental::Interceptor* CreateServerInterceptor(
      grpc::experimental::ServerRpcInfo* info) override;

 private:
  const std::shared_ptr<CallCounts> counts_;
};

/// What the observer has written into a call's metadata: clients cannot, for it erases theirs.
std::string method_of(const grpc::CallbackServerContext& context);
std::string request_id_of(const grpc::CallbackServerContext& context);

/// Text from outside as one line of a log: control characters become '?'.
std::string one_line(std::string text);

}  // namespace burnish
