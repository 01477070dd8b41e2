#include "server/s3/s3_bucket.h"

#include <algorithm>
#include <poll.h>

#include <spdlog/spdlog.h>

#include "server/s3/s3_upload.h"

namespace burnish {
namespace {

using std::chrono::milliseconds;
using std::chrono::steady_clock;

milliseconds time_until(steady_clock::time_point end) {
  return std::chrono::duration_cast<milliseconds>(end - steady_clock::now());
}

/// Waits, and asks now and then whether to go on.
Status wait(milliseconds time, const Progress& progress) {
  static constexpr milliseconds kStep{100};
  const auto end = steady_clock::now() + time;
  for (milliseconds left = time; left.count() > 0; left = time_until(end)) {
    if (!report(progress, "waiting for the bucket", 0))
      return cancelled("the transfer was cancelled");
    ::poll(nullptr, 0, static_cast<int>(std::min(left, kStep).count()));
  }
  return Status::ok();
}

}  // namespace

Result<S3Reply> S3Bucket::send(const MakeRequest& make, const Progress& progress) const {
  milliseconds pause = patience_.pause;
  for (int left = patience_.tries - 1;; --left, pause *= 2) {
    ASSIGN_OR_RETURN(const S3Credentials credentials, credentials_());
    const S3Request request = make();
    ASSIGN_OR_RETURN(S3Reply reply, exchange(address_, credentials, request, patience_));
    if (is_good(reply)) return reply;
    const Status failed =
        status_of(reply, std::string(request.method) + " " + address_.say(request.key));
    const bool has_time = !request.time_max || *request.time_max > pause;
    if (!may_succeed_later(reply) || left <= 0 || !has_time) return failed;
    spdlog::warn("{}; another try follows", failed.message());
    RETURN_IF_ERROR(wait(pause, progress));
  }
}

Result<S3Reply> S3Bucket::send_quickly(S3Request request) const {
  const auto end = steady_clock::now() + patience_.quick;
  return send([&] {
    request.time_max = time_until(end);
    return request;
  });
}

/// Asks for the keys that begin with `prefix`.
static S3Request list_keys(const std::string& prefix, int keys_max) {
  S3Request list{"GET", ""};
  list.query =
      "list-type=2&max-keys=" + std::to_string(keys_max) + "&prefix=" + percent_encoded(prefix);
  return list;
}

Status S3Bucket::check_access() const {
  RETURN_IF_ERROR(send_quickly(list_keys(address_.key(""), 1)).status());
  ASSIGN_OR_RETURN(S3Upload probe, S3Upload::begin(*this, "probe"));
  return probe.abort();
}

Result<uint64_t> S3Bucket::size_of(const std::string& name) const {
  ASSIGN_OR_RETURN(const S3Reply reply, send_quickly({"HEAD", address_.key(name)}));
  return reply.bytes;
}

Status S3Bucket::get(const std::string& name, uint64_t bytes_max, const Take& take,
                     const Progress& progress) const {
  const std::string key = address_.key(name);
  uint64_t done = 0;
  const auto take_more = [&](std::string_view piece) {
    if (piece.size() > bytes_max - done)
      return data_loss(address_.say(key) + " has more than " + std::to_string(bytes_max) +
                       " bytes");
    done += piece.size();
    return take(piece);
  };
  const auto make = [&] {
    S3Request request{"GET", key};
    request.take = take_more;
    request.first_byte = done;
    request.on_bytes = [&](uint64_t) {
      const double fraction = static_cast<double>(done) / static_cast<double>(bytes_max);
      return report(progress, "fetching", bytes_max == 0 ? 0 : fraction);
    };
    return request;
  };
  return send(make, progress).status();
}

Status S3Bucket::put(const std::string& name, std::string text) const {
  S3Request request{"PUT", address_.key(name)};
  request.body = text_body(std::move(text));
  return send_quickly(std::move(request)).status();
}

Status S3Bucket::remove_all(const std::string& name) const {
  static constexpr int kKeysMax = 100;  // a scan has two
  ASSIGN_OR_RETURN(const S3Reply list, send_quickly(list_keys(address_.key(name), kKeysMax)));
  for (const std::string& key : xml_texts(list.body, "Key"))
    RETURN_IF_ERROR(send_quickly({"DELETE", key}).status());
  return Status::ok();
}

}  // namespace burnish
