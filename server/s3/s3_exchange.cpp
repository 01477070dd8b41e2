#include "server/s3/s3_exchange.h"

#include <algorithm>
#include <utility>

#include <curl/curl.h>

#include "common/transfer/content_hash.h"
#include "server/s3/curl_handle.h"

namespace burnish {
namespace {

constexpr size_t kReplyBytesMax = 64 << 10;
constexpr long kSlowBytesPerSecond = 1 << 10;

/// The state that libcurl's callbacks work on.
struct Flight {
  const S3Request& request;
  CurlHandle& handle;
  S3Reply reply = {};
  Status failed = {};
  uint64_t sent = 0;
  uint64_t skipped = 0;
};

size_t send_bytes(char* to, size_t size, size_t count, void* data) {
  auto& flight = *static_cast<Flight*>(data);
  const S3Body& body = flight.request.body;
  const size_t wanted = std::min<uint64_t>(size * count, body.bytes - flight.sent);
  if (wanted == 0) return 0;
  const size_t read = body.read(flight.sent, to, wanted);
  if (read == 0) {
    flight.failed = data_loss("the file became shorter or unreadable while it was sent");
    return CURL_READFUNC_ABORT;
  }
  flight.sent += read;
  return read;
}

/// A connection that was lost before anything was answered is opened again by libcurl.
int seek(void* data, curl_off_t offset, int) {
  static_cast<Flight*>(data)->sent = static_cast<uint64_t>(offset);
  return CURL_SEEKFUNC_OK;
}

size_t take_bytes(char* bytes, size_t size, size_t count, void* data) {
  auto& flight = *static_cast<Flight*>(data);
  std::string_view piece(bytes, size * count);
  const int status = flight.handle.status();
  if (!flight.request.take || status / 100 != 2) {
    flight.reply.body.append(piece.substr(0, kReplyBytesMax - flight.reply.body.size()));
    return size * count;
  }
  if (status == 200) {  // not all services know ranges
    const auto skip = std::min<uint64_t>(flight.request.first_byte - flight.skipped, piece.size());
    flight.skipped += skip;
    piece.remove_prefix(skip);
  }
  if (!piece.empty()) flight.failed = flight.request.take(piece);
  return flight.failed.is_ok() ? size * count : 0;
}

int hear_progress(void* data, curl_off_t, curl_off_t received, curl_off_t, curl_off_t sent) {
  auto& flight = *static_cast<Flight*>(data);
  if (!flight.request.on_bytes) return 0;
  const auto bytes = static_cast<uint64_t>(std::max(received, sent));
  if (flight.request.on_bytes(bytes)) return 0;
  flight.failed = cancelled("the transfer was cancelled");
  return 1;
}

bool has_body(const S3Request& request) {
  return request.method == std::string_view("PUT") || request.method == std::string_view("POST");
}

/// libcurl sends a POST's body at once up to 1 MiB. It would ask before each body of an upload,
/// which is a round trip more.
void set_method(CurlHandle& handle, const S3Request& request) {
  if (request.method == std::string_view("HEAD")) return handle.set(CURLOPT_NOBODY, 1L);
  if (has_body(request)) {
    handle.set(CURLOPT_POST, 1L);
    handle.set(CURLOPT_POSTFIELDSIZE_LARGE, static_cast<curl_off_t>(request.body.bytes));
  }
  handle.set(CURLOPT_CUSTOMREQUEST, request.method);
}

void add_headers(CurlHandle& handle, const S3Request& request, const S3Credentials& credentials) {
  handle.add_header("x-amz-content-sha256: " + request.body.sha256);
  if (!credentials.token.empty()) handle.add_header("x-amz-security-token: " + credentials.token);
  if (has_body(request)) handle.add_header("Content-Type: application/octet-stream");
  if (request.first_byte > 0)
    handle.add_header("Range: bytes=" + std::to_string(request.first_byte) + "-");
}

void set_limits(CurlHandle& handle, const S3Request& request, const S3Patience& patience) {
  handle.set(CURLOPT_NOSIGNAL, 1L);
  handle.set(CURLOPT_CONNECTTIMEOUT_MS, static_cast<long>(patience.connect.count()));
  handle.set(CURLOPT_LOW_SPEED_LIMIT, kSlowBytesPerSecond);
  handle.set(CURLOPT_LOW_SPEED_TIME, static_cast<long>(patience.silence.count()));
  if (request.time_max)
    handle.set(CURLOPT_TIMEOUT_MS, std::max(1L, static_cast<long>(request.time_max->count())));
}

void set_callbacks(CurlHandle& handle, Flight& flight) {
  handle.set(CURLOPT_READFUNCTION, send_bytes);
  handle.set(CURLOPT_READDATA, &flight);
  handle.set(CURLOPT_SEEKFUNCTION, seek);
  handle.set(CURLOPT_SEEKDATA, &flight);
  handle.set(CURLOPT_WRITEFUNCTION, take_bytes);
  handle.set(CURLOPT_WRITEDATA, &flight);
  handle.set(CURLOPT_XFERINFOFUNCTION, hear_progress);
  handle.set(CURLOPT_XFERINFODATA, &flight);
  handle.set(CURLOPT_NOPROGRESS, 0L);
}

}  // namespace

S3Body text_body(std::string text) {
  ContentHash hash;
  hash.update(text);
  S3Body body{text.size(), hash.finish()};
  body.read = [text = std::move(text)](uint64_t offset, char* to, size_t bytes_max) {
    return text.copy(to, bytes_max, offset);
  };
  return body;
}

S3Body no_body() {
  static const S3Body body = text_body("");
  return body;
}

Result<S3Reply> exchange(const S3Address& address, const S3Credentials& credentials,
                         const S3Request& request, const S3Patience& patience) {
  CurlHandle handle;
  Flight flight{request, handle};
  const std::string query = request.query.empty() ? "" : "?" + request.query;
  handle.set(CURLOPT_PROTOCOLS_STR, "http,https");
  handle.set(CURLOPT_URL, (address.url(request.key) + query).c_str());
  handle.set(CURLOPT_HTTP_VERSION, static_cast<long>(CURL_HTTP_VERSION_1_1));
  if (!address.ca().empty()) handle.set(CURLOPT_CAINFO, address.ca().c_str());
  handle.set(CURLOPT_AWS_SIGV4, ("aws:amz:" + address.region() + ":s3").c_str());
  handle.set(CURLOPT_USERNAME, credentials.id.c_str());
  handle.set(CURLOPT_PASSWORD, credentials.secret.c_str());
  add_headers(handle, request, credentials);
  set_method(handle, request);
  set_limits(handle, request, patience);
  set_callbacks(handle, flight);

  std::string trouble = handle.perform();
  RETURN_IF_ERROR(flight.failed);
  S3Reply& reply = flight.reply;
  reply.trouble = std::move(trouble);
  reply.http = handle.status();
  reply.etag = handle.header("etag");
  reply.region = handle.header("x-amz-bucket-region");
  reply.bytes = handle.content_length();
  read_code(reply);
  return reply;
}

}  // namespace burnish
