#include "server/s3/s3_reply.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>

namespace burnish {

std::vector<std::string> xml_texts(const std::string& xml, const std::string& element) {
  const std::string open = "<" + element + ">";
  std::vector<std::string> texts;
  for (size_t at = 0; (at = xml.find(open, at)) != std::string::npos;) {
    at += open.size();
    const size_t end = xml.find('<', at);
    if (end == std::string::npos) break;
    texts.push_back(xml.substr(at, end - at));
  }
  return texts;
}

std::string xml_text(const std::string& xml, const std::string& element) {
  const auto texts = xml_texts(xml, element);
  return texts.empty() ? "" : texts.front();
}

/// Keeps the log to one line of plain letters, whoever answers.
void read_code(S3Reply& reply) {
  static constexpr size_t kLettersMax = 64;
  if (reply.body.find("<Error>") == std::string::npos) return;
  const std::string code = xml_text(reply.body, "Code");
  const bool is_word = !code.empty() && code.size() <= kLettersMax &&
                       std::ranges::all_of(code, [](unsigned char c) { return std::isalnum(c); });
  reply.code = is_word ? code : "Error";
}

bool is_good(const S3Reply& reply) {
  return reply.http / 100 == 2 && reply.code.empty() && reply.trouble.empty();
}

bool may_succeed_later(const S3Reply& reply) {
  static constexpr std::array<std::string_view, 4> kCodes = {"InternalError", "RequestTimeout",
                                                             "ServiceUnavailable", "SlowDown"};
  return !reply.trouble.empty() || reply.http >= 500 || reply.http == 429 ||
         std::ranges::find(kCodes, reply.code) != kCodes.end();
}

static StatusCode code_of(const S3Reply& reply) {
  if (reply.http == 507 || reply.http == 413 || reply.code == "QuotaExceeded")
    return StatusCode::kResourceExhausted;
  if (may_succeed_later(reply)) return StatusCode::kUnavailable;
  if (reply.code == "NoSuchBucket") return StatusCode::kFailedPrecondition;
  if (reply.http == 404) return StatusCode::kNotFound;
  const bool is_refused = reply.http / 100 == 3 || reply.http == 401 || reply.http == 403 ||
                          reply.code == "AuthorizationHeaderMalformed";
  return is_refused ? StatusCode::kFailedPrecondition : StatusCode::kInternal;
}

Status status_of(const S3Reply& reply, const std::string& what) {
  std::string why = reply.trouble;
  if (why.empty()) why = std::to_string(reply.http) + (reply.code.empty() ? "" : " ") + reply.code;
  if (!reply.region.empty() && reply.http / 100 != 2) why += "; the bucket is in " + reply.region;
  return {code_of(reply), what + ": " + why};
}

}  // namespace burnish
