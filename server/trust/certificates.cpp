#include "server/trust/certificates.h"

#include <cerrno>
#include <ctime>
#include <fstream>
#include <memory>
#include <sstream>

#include <openssl/pem.h>
#include <openssl/x509.h>

#include "server/trust/file_mode.h"

namespace burnish {
namespace {

template <auto Free>
struct FreeWith {
  template <typename T>
  void operator()(T* pointer) const {
    Free(pointer);
  }
};

using Bio = std::unique_ptr<BIO, FreeWith<BIO_free>>;
using Certificate = std::unique_ptr<X509, FreeWith<X509_free>>;
using Key = std::unique_ptr<EVP_PKEY, FreeWith<EVP_PKEY_free>>;

Result<std::string> read_file(const std::filesystem::path& path) {
  std::ifstream file(path);
  if (!file) return errno_status("cannot read " + path.string(), errno);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

Bio reader(const std::string& pem) {
  return Bio(BIO_new_mem_buf(pem.data(), static_cast<int>(pem.size())));
}

Result<Certificate> parse_certificate(const std::string& pem, const std::filesystem::path& path) {
  Certificate certificate(PEM_read_bio_X509(reader(pem).get(), nullptr, nullptr, nullptr));
  if (!certificate) return invalid_argument(path.string() + " does not hold a PEM certificate");
  return certificate;
}

// Returns an empty pass phrase: OpenSSL would ask for one on the terminal.
int no_pass_phrase(char*, int, int, void*) {
  return 0;
}

Status check_key(const std::string& pem, const CertificateFiles& files, X509& certificate) {
  const Key key(PEM_read_bio_PrivateKey(reader(pem).get(), nullptr, no_pass_phrase, nullptr));
  if (!key)
    return invalid_argument(files.key.string() + " does not hold a PEM key without a pass phrase");
  if (X509_check_private_key(&certificate, key.get()) == 1) return Status::ok();
  return invalid_argument(files.key.string() + " is not the key of " + files.certificate.string());
}

}  // namespace

Result<Certificates> read_certificates(const CertificateFiles& files) {
  RETURN_IF_ERROR(refuse_mode(files.key, S_IROTH | S_IWOTH, "read or written"));
  Certificates read;
  ASSIGN_OR_RETURN(read.certificate, read_file(files.certificate));
  ASSIGN_OR_RETURN(read.key, read_file(files.key));
  ASSIGN_OR_RETURN(const Certificate certificate,
                   parse_certificate(read.certificate, files.certificate));
  RETURN_IF_ERROR(check_key(read.key, files, *certificate));
  if (!files.client_ca.empty()) {
    ASSIGN_OR_RETURN(read.client_ca, read_file(files.client_ca));
    RETURN_IF_ERROR(parse_certificate(read.client_ca, files.client_ca).status());
  }
  std::tm expires = {};
  ASN1_TIME_to_tm(X509_get0_notAfter(certificate.get()), &expires);
  read.expires_unix_seconds = timegm(&expires);
  return read;
}

}  // namespace burnish
