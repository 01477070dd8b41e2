#include "server/rpc/admission/call_observer.h"

#include <algorithm>
#include <array>
#include <map>
#include <mutex>

#include <google/protobuf/message_lite.h>
#include <spdlog/spdlog.h>

#include "server/library/data_folder.h"
#include "server/metrics/live_objects.h"
#include "server/metrics/metrics.h"
#include "server/process/line_limiter.h"
#include "server/process/log_context.h"
#include "server/trust/role.h"
#include "server/trust/secret.h"
#include "server/web/gateway_mark.h"

namespace burnish {
namespace {

using grpc::experimental::InterceptionHookPoints;
using grpc::experimental::InterceptorBatchMethods;
using grpc::experimental::ServerRpcInfo;
using std::chrono::steady_clock;

constexpr char kMethodKey[] = "burnish-method";
constexpr char kRequestIdKey[] = "x-request-id";
constexpr char kPeerKey[] = "burnish-peer";
constexpr char kCertificateKey[] = "burnish-certificate";
constexpr std::string_view kCallsOfBytes[] = {"/burnish.v1.Editing/Edit",
                                              "/burnish.v1.Editing/UploadCellFields",
                                              "/burnish.v1.Library/Import"};

const char* code_name(grpc::StatusCode code) {
  static constexpr std::array kNames = {"OK",
                                        "CANCELLED",
                                        "UNKNOWN",
                                        "INVALID_ARGUMENT",
                                        "DEADLINE_EXCEEDED",
                                        "NOT_FOUND",
                                        "ALREADY_EXISTS",
                                        "PERMISSION_DENIED",
                                        "RESOURCE_EXHAUSTED",
                                        "FAILED_PRECONDITION",
                                        "ABORTED",
                                        "OUT_OF_RANGE",
                                        "UNIMPLEMENTED",
                                        "INTERNAL",
                                        "UNAVAILABLE",
                                        "DATA_LOSS",
                                        "UNAUTHENTICATED"};
  const auto index = static_cast<size_t>(code);
  return index < kNames.size() ? kNames[index] : "UNKNOWN";
}

using Metadata = std::multimap<grpc::string_ref, grpc::string_ref>;

std::string_view value_in(const Metadata& metadata, const char* key) {
  const auto found = metadata.find(key);
  if (found == metadata.end()) return {};
  return {found->second.data(), found->second.size()};
}

class CallObserver final : public grpc::experimental::Interceptor {
 public:
  CallObserver(ServerRpcInfo& info, std::shared_ptr<CallCounts> counts,
               std::shared_ptr<const std::string> gateway_secret)
      : info_(info),
        counts_(std::move(counts)),
        gateway_secret_(std::move(gateway_secret)),
        method_(info.method()),
        is_ours_(method_.starts_with("/burnish.")),
        takes_bytes_(std::ranges::count(kCallsOfBytes, method_) > 0),
        peer_(info.server_context()->peer()) {
    ++counts_->started;
    if (is_ours_) ++counts_->running;
  }

  ~CallObserver() override {
    if (is_ours_) --counts_->running;
    if (status_) report();
  }

  // The end of a call, in particular of a cancelled one, may come on another thread while its
  // status is sent.
  void Intercept(InterceptorBatchMethods* batch) override {
    {
      const std::lock_guard lock(mutex_);
      observe(*batch);
    }
    batch->Proceed();
  }

 private:
  void observe(InterceptorBatchMethods& batch) {
    const auto at = [&batch](InterceptionHookPoints point) {
      return batch.QueryInterceptionHookPoint(point);
    };
    if (at(InterceptionHookPoints::POST_RECV_INITIAL_METADATA))
      stamp(*batch.GetRecvInitialMetadata());
    if (at(InterceptionHookPoints::POST_RECV_MESSAGE)) take_message(batch.GetRecvMessage());
    if (at(InterceptionHookPoints::PRE_SEND_INITIAL_METADATA))
      batch.GetSendInitialMetadata()->emplace(kRequestIdKey, request_id_);
    if (at(InterceptionHookPoints::PRE_SEND_MESSAGE) && is_ours_)
      if (const grpc::ByteBuffer* bytes = batch.GetSerializedSendMessage())
        record_.bytes_sent += bytes->Length();
    if (at(InterceptionHookPoints::PRE_SEND_STATUS)) take_status(batch);
    if (at(InterceptionHookPoints::POST_RECV_CLOSE)) take_end();
  }

  void stamp(Metadata& metadata) {
    if (is_same_secret(value_in(metadata, kGatewaySecretKey), *gateway_secret_)) {
      peer_ = value_in(metadata, kGatewayPeerKey);
      certificate_ = value_in(metadata, kGatewayCertificateKey);
    }
    for (const char* key : {kMethodKey, kRequestIdKey, kPeerKey, kCertificateKey, kGatewaySecretKey,
                            kGatewayPeerKey, kGatewayCertificateKey})
      metadata.erase(key);
    metadata.emplace(kMethodKey, method_);
    metadata.emplace(kRequestIdKey, request_id_);
    metadata.emplace(kPeerKey, peer_);
    metadata.emplace(kCertificateKey, certificate_);
  }

  void take_message(const void* message) {
    lacks_message_ = !message;
    // gRPC passes the message without its type. Messages of this server's services are protobuf's,
    // except for calls that take bytes.
    if (!message || !is_ours_) return;
    record_.bytes_received +=
        takes_bytes_ ? static_cast<const grpc::ByteBuffer*>(message)->Length()
                     : static_cast<const google::protobuf::MessageLite*>(message)->ByteSizeLong();
  }

  bool is_cancelled_for_want_of_a_message() const {
    return lacks_message_ && info_.server_context()->IsCancelled();
  }

  // A cancelled call shows only after its failed read; in a stream sometimes only after the status
  // for that read was sent.
  void take_end() {
    if (!is_malformed_ && is_cancelled_for_want_of_a_message()) is_cut_off_ = true;
  }

  void take_status(InterceptorBatchMethods& batch) {
    const bool is_single_request = info_.type() == ServerRpcInfo::Type::UNARY ||
                                   info_.type() == ServerRpcInfo::Type::SERVER_STREAMING;
    is_cut_off_ = is_cancelled_for_want_of_a_message();
    is_malformed_ = lacks_message_ && is_single_request && !is_cut_off_;
    if (is_malformed_)  // gRPC itself would say UNIMPLEMENTED
      batch.ModifySendStatus(
          {grpc::StatusCode::INVALID_ARGUMENT, "the message is not a request of " + method_});
    status_ = batch.GetSendStatus();
  }

  void report() {
    const double seconds = std::chrono::duration<double>(steady_clock::now() - start_).count();
    // Labels are kept for ever, so no client may invent one.
    record_.method = least_role(method_) ? std::string_view(method_) : "unknown";
    record_.code = code_name(status_->error_code());
    record_.seconds = seconds;
    metrics().count_call(record_);
    if (is_malformed_) metrics().count_refusal(Refusal::kMalformed);
    if (is_cut_off_) metrics().count_refusal(Refusal::kCutOff);
    if (is_limited()) metrics().count_refusal(Refusal::kLimit);
    if (!spdlog::should_log(level()) || !may_log(LineKind::kEndedCall)) return;
    const LogContext context(request_id_);
    spdlog::log(level(), "{} from {}: {}{} after {:.1f} ms{}{}", method_, peer_, record_.code,
                is_cut_off_ ? ", cut off (cancelled, or a message above the limit)" : "",
                seconds * 1000, status_->ok() ? "" : ": ", status_->error_message());
  }

  spdlog::level::level_enum level() const {
    if (status_->ok()) return spdlog::level::debug;
    return is_limited() ? spdlog::level::warn : spdlog::level::info;
  }

  /// Returns whether a limit, or a full disk, has refused the call.
  bool is_limited() const { return status_->error_code() == grpc::StatusCode::RESOURCE_EXHAUSTED; }

  ServerRpcInfo& info_;
  const std::shared_ptr<CallCounts> counts_;
  const std::shared_ptr<const std::string> gateway_secret_;
  const std::string method_;
  const bool is_ours_;
  const bool takes_bytes_;
  std::string peer_;         // settled by the call's headers
  std::string certificate_;  // likewise
  const std::string request_id_ = random_name();
  const steady_clock::time_point start_ = steady_clock::now();
  const LiveObject live_{LiveKind::kCall};
  std::mutex mutex_;  // guards the following members
  CallRecord record_;
  bool lacks_message_ = false;
  bool is_cut_off_ = false;
  bool is_malformed_ = false;
  std::optional<grpc::Status> status_;
};

}  // namespace

grpc::experimental::Interceptor* CallObserverFactory::CreateServerInterceptor(ServerRpcInfo* info) {
  if (!is_open_to_all(info->method())) on_call_(info->server_context()->peer());
  return new CallObserver(*info, counts_, gateway_secret_);
}

std::string method_of(const grpc::CallbackServerContext& context) {
  return std::string(value_in(context.client_metadata(), kMethodKey));
}

std::string request_id_of(const grpc::CallbackServerContext& context) {
  return std::string(value_in(context.client_metadata(), kRequestIdKey));
}

std::string peer_of(const grpc::CallbackServerContext& context) {
  return std::string(value_in(context.client_metadata(), kPeerKey));
}

std::string_view gateway_certificate_of(const grpc::CallbackServerContext& context) {
  return value_in(context.client_metadata(), kCertificateKey);
}

}  // namespace burnish
