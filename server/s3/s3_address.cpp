#include "server/s3/s3_address.h"

#include <algorithm>
#include <cctype>
#include <cstring>
#include <string_view>

namespace burnish {
namespace {

constexpr std::string_view kScheme = "s3://";
constexpr std::string_view kLower = "abcdefghijklmnopqrstuvwxyz0123456789";

bool has_only(std::string_view text, const std::string& characters) {
  return text.find_first_not_of(characters) == std::string_view::npos;
}

Status check_bucket(const std::string& bucket) {
  const bool fits =
      bucket.size() >= 3 && bucket.size() <= 63 && has_only(bucket, std::string(kLower) + "-.") &&
      kLower.find(bucket.front()) != kLower.npos && kLower.find(bucket.back()) != kLower.npos;
  if (fits) return Status::ok();
  return invalid_argument("library.shared names the bucket '" + bucket +
                          "', which is not 3 to 63 lower-case letters, digits, '-' and '.'");
}

/// Keys have such characters alone, so that they stand in URLs as they are.
Status check_prefix(const std::string& prefix) {
  static const std::string kAllowed = std::string(kLower) + "ABCDEFGHIJKLMNOPQRSTUVWXYZ-_./";
  const std::string parts = "/" + prefix;
  const auto has = [&](const char* part) { return parts.find(part) != parts.npos; };
  if (has_only(prefix, kAllowed) && !has("//") && !has("/./") && !has("/../") &&
      prefix.size() <= 512)
    return Status::ok();
  return invalid_argument(
      "library.shared names the prefix '" + prefix +
      "', which is not up to 512 letters, digits, '-', '_' and '.' between single '/'");
}

Status check_endpoint(const std::string& endpoint) {
  std::string_view host = endpoint;
  const bool is_http = host.starts_with("http://") || host.starts_with("https://");
  host.remove_prefix(is_http ? host.find("//") + 2 : 0);
  static const std::string kAllowed = std::string(kLower) + "ABCDEFGHIJKLMNOPQRSTUVWXYZ-_.:[]";
  if (is_http && !host.empty() && has_only(host, kAllowed)) return Status::ok();
  return invalid_argument(
      "library.s3_endpoint is not http://HOST[:PORT] or https://HOST[:PORT], without a user and "
      "without a path");
}

/// The region is a part of AWS's host, and of what is signed.
Status check_region(const std::string& region) {
  if (!region.empty() && region.size() <= 63 && has_only(region, std::string(kLower) + "-"))
    return Status::ok();
  return invalid_argument("library.s3_region = '" + region + "' is not a region such as us-east-1");
}

}  // namespace

std::string percent_encoded(const std::string& text) {
  static constexpr char kDigits[] = "0123456789ABCDEF";
  std::string encoded;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    const bool is_plain = byte < 0x80 && (std::isalnum(byte) != 0 || std::strchr("-_.~", c));
    if (is_plain) {
      encoded += c;
    } else {
      encoded += {'%', kDigits[byte >> 4], kDigits[byte & 15]};
    }
  }
  return encoded;
}

bool is_s3_uri(const std::string& text) {
  return text.starts_with(kScheme);
}

Result<S3Address> S3Address::parse(const S3Settings& settings) {
  if (!is_s3_uri(settings.uri))
    return invalid_argument("library.shared = '" + settings.uri + "' is not s3://BUCKET[/PREFIX]");
  const std::string place = settings.uri.substr(kScheme.size());
  const size_t slash = std::min(place.find('/'), place.size());
  S3Address address;
  address.bucket_ = place.substr(0, slash);
  address.prefix_ = place.substr(std::min(slash + 1, place.size()));
  if (!address.prefix_.empty() && !address.prefix_.ends_with('/')) address.prefix_ += '/';
  address.region_ = settings.region;
  address.ca_ = settings.ca;
  RETURN_IF_ERROR(check_bucket(address.bucket_));
  RETURN_IF_ERROR(check_prefix(address.prefix_));
  RETURN_IF_ERROR(check_region(address.region_));
  const bool is_aws = settings.endpoint.empty();
  address.endpoint_ =
      is_aws ? "https://s3." + settings.region + ".amazonaws.com" : settings.endpoint;
  RETURN_IF_ERROR(check_endpoint(address.endpoint_));
  // A certificate for *.s3.amazonaws.com does not fit a name with a dot.
  const bool has_dot = address.bucket_.find('.') != std::string::npos;
  address.is_virtual_ =
      settings.addressing == "virtual" || (settings.addressing == "auto" && is_aws && !has_dot);
  return address;
}

std::string S3Address::url(const std::string& key) const {
  if (!is_virtual_) return endpoint_ + "/" + bucket_ + (key.empty() ? "" : "/" + key);
  const size_t host = endpoint_.find("//") + 2;
  return endpoint_.substr(0, host) + bucket_ + "." + endpoint_.substr(host) + "/" + key;
}

}  // namespace burnish
