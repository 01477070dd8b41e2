#include "server/rpc/credentials.h"

#include <mutex>
#include <string_view>

#include <grpc/grpc_security.h>
#include <grpc/support/log.h>
#include <spdlog/spdlog.h>

#include "server/metrics/metrics.h"

namespace burnish {
namespace {

/// Credentials of gRPC's C interface, which has two things that its C++ interface lacks: a
/// certificate fetcher, and a look at the calls of plaintext connections.
class Credentials : public grpc::ServerCredentials {
 public:
  Credentials(grpc_server_credentials* credentials, std::shared_ptr<CallCounts> counts)
      : credentials_(credentials), counts_(std::move(counts)) {
    grpc_server_credentials_set_auth_metadata_processor(credentials_,
                                                        {&count, [](void*) {}, counts_.get()});
  }
  ~Credentials() override { grpc_server_credentials_release(credentials_); }

  void SetAuthMetadataProcessor(const std::shared_ptr<grpc::AuthMetadataProcessor>&) override {}

 private:
  // Every call's headers come here. Who may call is decided where the peer is known: CallGuard.
  static void count(void* state, grpc_auth_context*, const grpc_metadata*, size_t,
                    grpc_process_auth_metadata_done_cb done, void* call) {
    ++static_cast<CallCounts*>(state)->arrived;
    done(call, nullptr, 0, nullptr, 0, GRPC_STATUS_OK, nullptr);
  }

  int AddPortToServer(const std::string& address, grpc_server* server) override {
    return grpc_server_add_http2_port(server, address.c_str(), credentials_);
  }

  grpc_server_credentials* credentials_;
  const std::shared_ptr<CallCounts> counts_;
};

/// Gives gRPC the certificates at its first handshake and whenever they have changed.
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
    // Without a client CA no client is asked for a certificate, but gRPC wants some root.
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
                 std::shared_ptr<CallCounts> counts)
      : Credentials(grpc_ssl_server_credentials_create_with_options(
                        grpc_ssl_server_credentials_create_options_using_config_fetcher(
                            request, &Fetcher::fetch, fetcher.get())),
                    std::move(counts)),
        fetcher_(std::move(fetcher)) {}

 private:
  const std::unique_ptr<Fetcher> fetcher_;
};

void log_for_grpc(gpr_log_func_args* line) {
  const std::string_view message(line->message);
  if (message.find("andshake failed") != std::string_view::npos) {
    metrics().count_refusal(Refusal::kHandshake);
    spdlog::warn("refused a connection: {}", one_line(std::string(message)));
  } else {
    spdlog::error("gRPC: {}", one_line(std::string(message)));
  }
}

}  // namespace

std::shared_ptr<grpc::ServerCredentials> tls_credentials(const Reloaded<Certificates>& certificates,
                                                         bool client_certificate_required,
                                                         std::shared_ptr<CallCounts> counts) {
  auto request = GRPC_SSL_DONT_REQUEST_CLIENT_CERTIFICATE;
  if (!certificates.get()->client_ca.empty())
    request = client_certificate_required
                  ? GRPC_SSL_REQUEST_AND_REQUIRE_CLIENT_CERTIFICATE_AND_VERIFY
                  : GRPC_SSL_REQUEST_CLIENT_CERTIFICATE_AND_VERIFY;
  return std::make_shared<TlsCredentials>(std::make_unique<Fetcher>(certificates), request,
                                          std::move(counts));
}

std::shared_ptr<grpc::ServerCredentials> plaintext_credentials(std::shared_ptr<CallCounts> counts) {
  return std::make_shared<Credentials>(grpc_insecure_server_credentials_create(),
                                       std::move(counts));
}

void adopt_grpc_log() {
  gpr_set_log_verbosity(GPR_LOG_SEVERITY_ERROR);
  gpr_set_log_function(&log_for_grpc);
}

}  // namespace burnish
