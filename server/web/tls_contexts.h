#pragma once

#include <memory>
#include <mutex>
#include <string>

#include <boost/asio/ssl/context.hpp>

#include "server/trust/certificates.h"
#include "server/trust/reloaded.h"

namespace burnish {

/// OpenSSL's settings for the certificates of the moment. Thread-safe.
class TlsContexts {
 public:
  /// With a client CA, clients show a certificate: all of them, or those that have one. Needs:
  /// `certificates` outlives it.
  TlsContexts(const Reloaded<Certificates>& certificates, bool client_certificate_required)
      : certificates_(certificates), client_certificate_required_(client_certificate_required) {}

  /// Returns the settings for a new connection. Fails: internal if OpenSSL refuses them.
  Result<std::shared_ptr<boost::asio::ssl::context>> current();

 private:
  const Reloaded<Certificates>& certificates_;
  const bool client_certificate_required_;
  std::mutex mutex_;  // guards the following members
  std::shared_ptr<const Certificates> made_of_;
  std::shared_ptr<boost::asio::ssl::context> context_;
};

/// Returns the common name of the peer's verified certificate; empty for none.
std::string certificate_name(SSL* connection);

}  // namespace burnish
