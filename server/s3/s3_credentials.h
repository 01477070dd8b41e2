#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "common/base/status.h"

namespace burnish {

/// Who signs requests. No message and no log has any of it.
struct S3Credentials {
  std::string id;
  std::string secret;
  std::string token;  ///< of temporary credentials; empty: none
};

/// Says the credentials of a request: temporary ones change while the server runs.
using S3CredentialsSource = std::function<Result<S3Credentials>()>;

/// Reads aws_access_key_id, aws_secret_access_key and aws_session_token: lines of the section
/// [default], or of a file without sections. Fails: not_found; failed_precondition if everybody can
/// read the file; invalid_argument that names a missing line.
Result<S3Credentials> read_s3_credentials(const std::filesystem::path& file);

/// Takes AWS_ACCESS_KEY_ID, AWS_SECRET_ACCESS_KEY and AWS_SESSION_TOKEN of the environment. Fails:
/// not_found that names what is missing.
Result<S3Credentials> s3_credentials_of_environment();

}  // namespace burnish
