#include "server/web/tls_contexts.h"

#include <boost/asio/buffer.hpp>
#include <openssl/ssl.h>
#include <openssl/x509.h>

namespace burnish {

namespace ssl = boost::asio::ssl;

static std::shared_ptr<ssl::context> make_context(const Certificates& certificates,
                                                  bool client_certificate_required) {
  auto context = std::make_shared<ssl::context>(ssl::context::tls_server);
  context->set_options(ssl::context::default_workarounds | ssl::context::no_tlsv1 |
                       ssl::context::no_tlsv1_1 | SSL_OP_NO_RENEGOTIATION);
  context->use_certificate_chain(boost::asio::buffer(certificates.certificate));
  context->use_private_key(boost::asio::buffer(certificates.key), ssl::context::pem);
  if (certificates.client_ca.empty()) return context;
  context->add_certificate_authority(boost::asio::buffer(certificates.client_ca));
  context->set_verify_mode(client_certificate_required
                               ? ssl::verify_peer | ssl::verify_fail_if_no_peer_cert
                               : ssl::verify_peer);
  // OpenSSL continues a session of a verified client only under a name of its own.
  static constexpr unsigned char kName[] = "burnish";
  SSL_CTX_set_session_id_context(context->native_handle(), kName, sizeof(kName));
  return context;
}

Result<std::shared_ptr<ssl::context>> TlsContexts::current() {
  const std::lock_guard lock(mutex_);
  const auto now = certificates_.get();
  if (now == made_of_) return context_;
  try {
    context_ = make_context(*now, client_certificate_required_);
  } catch (const boost::system::system_error& error) {
    return internal_error("OpenSSL refuses the certificates: " + std::string(error.what()));
  }
  made_of_ = now;
  return context_;
}

std::string certificate_name(SSL* connection) {
  X509* certificate = SSL_get1_peer_certificate(connection);
  if (certificate == nullptr) return {};
  char name[256] = "";
  const int size = X509_NAME_get_text_by_NID(X509_get_subject_name(certificate), NID_commonName,
                                             name, sizeof(name));
  X509_free(certificate);
  return size > 0 ? std::string(name, static_cast<size_t>(size)) : std::string();
}

}  // namespace burnish
