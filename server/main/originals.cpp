#include "server/main/originals.h"

#include "server/library/shared_bucket.h"
#include "server/library/shared_folder.h"

namespace burnish {

/// Says what the owner of the server may do about a bucket that cannot be used.
static Status advised(const Status& status, const ServerConfig& config, const S3Address& address) {
  std::string advice = "is the endpoint right, and does it answer?";
  if (status.code() == StatusCode::kFailedPrecondition)
    advice =
        "make the bucket, or see to library.s3_region, to the credentials, and to their rights: "
        "to list the bucket, and to read, write and delete in it";
  return {status.code(), "library.shared = '" + config.library_shared.string() + "' at " +
                             address.endpoint() + " cannot be used: " + status.message() + "; " +
                             advice};
}

static Result<std::unique_ptr<OriginalStore>> open_bucket(const ServerConfig& config) {
  ASSIGN_OR_RETURN(const S3Address address,
                   S3Address::parse({config.library_shared.string(), config.s3_endpoint,
                                     config.s3_region, config.s3_addressing, config.s3_ca}));
  S3CredentialsSource credentials = s3_credentials_of_environment;
  if (!config.s3_credentials.empty())
    credentials = [file = config.s3_credentials] { return read_s3_credentials(file); };
  RETURN_IF_ERROR(credentials().status());
  auto bucket = SharedBucket::open(address, std::move(credentials));
  if (!bucket.is_ok()) return advised(bucket.status(), config, address);
  return std::unique_ptr<OriginalStore>(std::move(*bucket));
}

Result<std::unique_ptr<OriginalStore>> open_originals(const ServerConfig& config) {
  if (is_s3_uri(config.library_shared.string())) return open_bucket(config);
  ASSIGN_OR_RETURN(auto folder, SharedFolder::open(config.library_shared, config.fleet_name));
  return std::unique_ptr<OriginalStore>(std::move(folder));
}

}  // namespace burnish
