#include "server/s3/s3_exchange.h"

#include <algorithm>
#include <memory>

#include <curl/curl.h>

#include "common/base/check.h"
#include "common/transfer/content_hash.h"

namespace burnish {
namespace {

constexpr size_t kReplyBytesMax = 64 << 10;
constexpr long kSlowBytesPerSecond = 1 << 10;

struct EndHandle {
  void operator()(CURL* handle) const { curl_easy_cleanup(handle); }
};
struct EndList {
  void operator()(curl_slist* list) const { curl_slist_free_all(list); }
};
using Headers = std::unique_ptr<curl_slist, EndList>;

void add(Headers& headers, const std::string& line) {
  curl_slist* longer = curl_slist_append(headers.get(), line.c_str());
  BURNISH_CHECK(longer != nullptr, "libcurl has no memory");
  (void)headers.release();
  headers.reset(longer);
}

/// What libcurl's callbacks work on.
struct Flight {
  const S3Request& request;
  CURL* handle;
  S3Reply reply = {};
  Status failed = {};
  uint64_t sent = 0;
  uint64_t skipped = 0;
};

long http_status(CURL* handle) {
  long status = 0;
  curl_easy_getinfo(handle, CURLINFO_RESPONSE_CODE, &status);
  return status;
}

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
  const long status = http_status(flight.handle);
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

std::string header(CURL* handle, const char* name) {
  curl_header* found = nullptr;
  return curl_easy_header(handle, name, 0, CURLH_HEADER, -1, &found) == CURLHE_OK ? found->value
                                                                                  : "";
}

template <typename Value>
void set(CURL* handle, CURLoption option, Value value) {
  const CURLcode code = curl_easy_setopt(handle, option, value);
  BURNISH_CHECK(code == CURLE_OK, curl_easy_strerror(code));
}

bool has_body(const S3Request& request) {
  return request.method == std::string_view("PUT") || request.method == std::string_view("POST");
}

/// What libcurl takes for a POST waits until the service wants it if it is larger than 1 MiB. An
/// upload would do so with each body, which is a round trip more.
void set_method(CURL* handle, const S3Request& request) {
  if (request.method == std::string_view("HEAD")) return set(handle, CURLOPT_NOBODY, 1L);
  if (has_body(request)) {
    set(handle, CURLOPT_POST, 1L);
    set(handle, CURLOPT_POSTFIELDSIZE_LARGE, static_cast<curl_off_t>(request.body.bytes));
  }
  set(handle, CURLOPT_CUSTOMREQUEST, request.method);
}

Headers headers_of(const S3Request& request, const S3Credentials& credentials) {
  Headers headers;
  add(headers, "x-amz-content-sha256: " + request.body.sha256);
  if (!credentials.token.empty()) add(headers, "x-amz-security-token: " + credentials.token);
  if (has_body(request)) add(headers, "Content-Type: application/octet-stream");
  if (request.first_byte > 0)
    add(headers, "Range: bytes=" + std::to_string(request.first_byte) + "-");
  return headers;
}

void set_limits(CURL* handle, const S3Request& request, const S3Patience& patience) {
  set(handle, CURLOPT_NOSIGNAL, 1L);
  set(handle, CURLOPT_CONNECTTIMEOUT_MS, static_cast<long>(patience.connect.count()));
  set(handle, CURLOPT_LOW_SPEED_LIMIT, kSlowBytesPerSecond);
  set(handle, CURLOPT_LOW_SPEED_TIME, static_cast<long>(patience.silence.count()));
  if (request.time_max)
    set(handle, CURLOPT_TIMEOUT_MS, std::max(1L, static_cast<long>(request.time_max->count())));
}

void set_callbacks(CURL* handle, Flight& flight) {
  set(handle, CURLOPT_READFUNCTION, send_bytes);
  set(handle, CURLOPT_READDATA, &flight);
  set(handle, CURLOPT_SEEKFUNCTION, seek);
  set(handle, CURLOPT_SEEKDATA, &flight);
  set(handle, CURLOPT_WRITEFUNCTION, take_bytes);
  set(handle, CURLOPT_WRITEDATA, &flight);
  set(handle, CURLOPT_XFERINFOFUNCTION, hear_progress);
  set(handle, CURLOPT_XFERINFODATA, &flight);
  set(handle, CURLOPT_NOPROGRESS, 0L);
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
  static const CURLcode is_ready = curl_global_init(CURL_GLOBAL_DEFAULT);
  BURNISH_CHECK(is_ready == CURLE_OK, "libcurl does not start");
  const std::unique_ptr<CURL, EndHandle> owner(curl_easy_init());
  BURNISH_CHECK(owner != nullptr, "libcurl has no memory");
  CURL* handle = owner.get();
  Flight flight{request, handle};
  char words[CURL_ERROR_SIZE] = "";
  const std::string query = request.query.empty() ? "" : "?" + request.query;
  set(handle, CURLOPT_ERRORBUFFER, words);
  set(handle, CURLOPT_PROTOCOLS_STR, "http,https");
  set(handle, CURLOPT_URL, (address.url(request.key) + query).c_str());
  set(handle, CURLOPT_HTTP_VERSION, static_cast<long>(CURL_HTTP_VERSION_1_1));
  if (!address.ca().empty()) set(handle, CURLOPT_CAINFO, address.ca().c_str());
  set(handle, CURLOPT_AWS_SIGV4, ("aws:amz:" + address.region() + ":s3").c_str());
  set(handle, CURLOPT_USERNAME, credentials.id.c_str());
  set(handle, CURLOPT_PASSWORD, credentials.secret.c_str());
  const Headers headers = headers_of(request, credentials);
  set(handle, CURLOPT_HTTPHEADER, headers.get());
  set_method(handle, request);
  set_limits(handle, request, patience);
  set_callbacks(handle, flight);

  const CURLcode code = curl_easy_perform(handle);
  RETURN_IF_ERROR(flight.failed);
  S3Reply& reply = flight.reply;
  if (code != CURLE_OK) reply.trouble = words[0] != '\0' ? words : curl_easy_strerror(code);
  reply.http = static_cast<int>(http_status(handle));
  reply.etag = header(handle, "etag");
  reply.region = header(handle, "x-amz-bucket-region");
  curl_off_t length = 0;
  curl_easy_getinfo(handle, CURLINFO_CONTENT_LENGTH_DOWNLOAD_T, &length);
  reply.bytes = static_cast<uint64_t>(std::max<curl_off_t>(length, 0));
  read_code(reply);
  return reply;
}

}  // namespace burnish
