#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "common/base/status.h"

namespace burnish {

/// PEM files. With an empty client_ca no client is asked for a certificate.
struct CertificateFiles {
  std::filesystem::path certificate;  ///< of the server, with the chain below it
  std::filesystem::path key;
  std::filesystem::path client_ca;
};

struct Certificates {
  std::string certificate;
  std::string key;
  std::string client_ca;
  int64_t expires_unix_seconds = 0;  ///< end of the server's certificate
};

/// Reads the files and checks that the key belongs to the certificate. Fails: as errno says;
/// failed_precondition if everybody can read the key; invalid_argument that names the wrong file.
Result<Certificates> read_certificates(const CertificateFiles& files);

}  // namespace burnish
