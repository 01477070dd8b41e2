#include "server/rpc/admission/credentials.h"

#include <mutex>
#include <span>
#include <string_view>

#include <grpc/grpc_security.h>
#include <grpc/grpc_security_constants.h>
#include <grpc/support/log.h>
#include <spdlog/spdlog.h>

#include "server/metrics/metrics.h"
#include "server/process/line_limiter.h"
#include "server/rpc/transport/to_grpc.h"

namespace burnish {
namespace {

/// Credentials of gRPC's C interface. Its C++ interface lacks two things: a certificate fetcher,
/// and a look at the calls of plaintext connections.
class Credentials : public grpc::ServerCredentials {
 public:
  Credentials(grpc_server_credentials* credentials, std::shared_ptr<const Admission> admission)
      : credentials_(credentials) {
    grpc_server_credentials_set_auth_metadata_processor(
        credentials_, {&admit, [](void* state) { delete static_cast<State*>(state); },
                       new State(std::move(admission))});
  }
  ~Credentials() override { grpc_server_credentials_release(credentials_); }

  void SetAuthMetadataProcessor(const std::shared_ptr<grpc::AuthMetadataProcessor>&) override {}

 private:
  using State = std::shared_ptr<const Admission>;  // gRPC holds it while connections live

  // Gets every call's headers, ":path" among them, before its first message is read.
  static void admit(void* state, grpc_auth_context* connection, const grpc_metadata* headers,
                    size_t count, grpc_process_auth_metadata_done_cb done, void* call) {
    std::string_view method;
    Proof proof;
    for (const grpc_metadata& header : std::span(headers, count)) {
      if (view(header.key) == ":path") method = view(header.value);
      if (view(header.key) == "authorization") proof.authorization = view(header.value);
    }
    proof.certificate_common_name = common_name(connection);
    const Status status = (*static_cast<State*>(state))->admit(method, proof);
    const grpc::Status told = to_grpc(status);
    done(call, nullptr, 0, nullptr, 0, static_cast<grpc_status_code>(told.error_code()),
         told.ok() ? nullptr : told.error_message().c_str());
  }

  static std::string_view view(const grpc_slice& slice) {
    return {reinterpret_cast<const char*>(GRPC_SLICE_START_PTR(slice)), GRPC_SLICE_LENGTH(slice)};
  }

  static std::string_view common_name(const grpc_auth_context* connection) {
    auto names = grpc_auth_context_find_properties_by_name(connection, GRPC_X509_CN_PROPERTY_NAME);
    const grpc_auth_property* name = grpc_auth_property_iterator_next(&names);
    return name ? std::string_view(name->value, name->value_length) : std::string_view();
  }

  int AddPortToServer(const std::string& address, grpc_server* server) override {
    return grpc_server_add_http2_port(server, address.c_str(), credentials_);
  }

  grpc_server_credentials* credentials_;
};

/// Gives gRPC the certificates at its first handshake and after each change.
class Fetcher {
 public:
  explicit Fetcher(const Reloaded<Certificates>& certificates) : certificates_(certificates) {}

  static grpc_ssl_certificate_config_reload_status fetch(
      void* self, grpc_ssl_server_certificate_config** config) {
    return static_cast<Fetcher*>(self)->give(config);
  }

 private:
  grpc_ssl_certificate_config_reload_status give(grpc_ssl_server_certificate_config** config) {
    const std::lock_guard lock(mutex_);
    const auto now = certificates_.get();
    if (now == given_) return GRPC_SSL_CERTIFICATE_CONFIG_RELOAD_UNCHANGED;
    const grpc_ssl_pem_key_cert_pair pair = {now->key.c_str(), now->certificate.c_str()};
    // Without a client CA no client is asked for a certificate, but gRPC needs some root.
    const std::string& client_ca = now->client_ca.empty() ? now->certificate : now->client_ca;
    *config = grpc_ssl_server_certificate_config_create(client_ca.c_str(), &pair, 1);
    given_ = now;
    return GRPC_SSL_CERTIFICATE_CONFIG_RELOAD_NEW;
  }

  const Reloaded<Certificates>& certificates_;
  std::mutex mutex_;
  std::shared_ptr<const Certificates> given_;
};

class TlsCredentials final : public Credentials {
 public:
  TlsCredentials(std::unique_ptr<Fetcher> fetcher, grpc_ssl_client_certificate_request_type request,
                 std::shared_ptr<const Admission> admission)
      : Credentials(grpc_ssl_server_credentials_create_with_options(
                        grpc_ssl_server_credentials_create_options_using_config_fetcher(
                            request, &Fetcher::fetch, fetcher.get())),
                    std::move(admission)),
        fetcher_(std::move(fetcher)) {}

 private:
  const std::unique_ptr<Fetcher> fetcher_;
};

void log_for_grpc(gpr_log_func_args* line) {
  const std::string_view message(line->message);
  if (message.find("andshake failed") != std::string_view::npos) {
    metrics().count_refusal(Refusal::kHandshake);
    if (may_log(LineKind::kConnection)) spdlog::warn("refused a connection: {}", message);
  } else if (may_log(LineKind::kTransport)) {
    spdlog::error("gRPC: {}", message);
  }
}

}  // namespace

std::shared_ptr<grpc::ServerCredentials> tls_credentials(
    const Reloaded<Certificates>& certificates, bool client_certificate_required,
    std::shared_ptr<const Admission> admission) {
  auto request = GRPC_SSL_DONT_REQUEST_CLIENT_CERTIFICATE;
  if (!certificates.get()->client_ca.empty())
    request = client_certificate_required
                  ? GRPC_SSL_REQUEST_AND_REQUIRE_CLIENT_CERTIFICATE_AND_VERIFY
                  : GRPC_SSL_REQUEST_CLIENT_CERTIFICATE_AND_VERIFY;
  return std::make_shared<TlsCredentials>(std::make_unique<Fetcher>(certificates), request,
                                          std::move(admission));
}

std::shared_ptr<grpc::ServerCredentials> plaintext_credentials(
    std::shared_ptr<const Admission> admission) {
  return std::make_shared<Credentials>(grpc_insecure_server_credentials_create(),
                                       std::move(admission));
}

void adopt_grpc_log() {
  gpr_set_log_verbosity(GPR_LOG_SEVERITY_ERROR);
  gpr_set_log_function(&log_for_grpc);
}

}  // namespace burnish
