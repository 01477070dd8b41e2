#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "common/base/status.h"

namespace burnish {

/// PEM files; an empty client_ca asks clients for no certificate.
struct CertificateFiles {
  std::filesystem::path certificate;  ///< of the server, with the chain below it
  std::filesystem::path key;
  std::filesystem::path client_ca;
};

struct Certificates {
  std::string certificate;
  std::string key;
  std::string client_ca;
  int64_t expires_unix_seconds = 0;  ///< of the server's certificate
};

/// Reads the files and checks that the key is the certificate's.
/// Fails: as errno says; failed_precondition when everybody can read the key; invalid_argument
/// naming the file that is not what it should be.
Result<Certificates> read_certificates(const CertificateFiles& files);

}  // namespace burnish
