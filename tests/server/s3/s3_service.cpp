#include "tests/server/s3/s3_service.h"

#include <cstdlib>

#include "common/base/check.h"

namespace burnish {

static constexpr std::chrono::seconds kStartTime{60};

bool S3Service::is_installed() {
  static const bool is_there =
      std::system(PYTHON " -B -c 'import swift.common.middleware.s3api' 2>/dev/null") == 0;
  return is_there;
}

S3Service::S3Service(std::string certificate, std::string key)
    : certificate_(std::move(certificate)), key_(std::move(key)) {
  ::setenv("no_proxy", "127.0.0.1,localhost,.localhost", 1);
  start();
  if (!certificate_.empty()) return;
  const Status made = bucket(short_patience()).send_quickly({"PUT", ""}).status();
  BURNISH_CHECK(made.is_ok(), made.message());
}

void S3Service::start() {
  std::vector<std::string> words = {PYTHON, "-B", S3_SERVICE, folder_.path().string(),
                                    port_,  kId,  kSecret};
  if (!certificate_.empty()) words.insert(words.end(), {certificate_, key_});
  const auto output = folder_ / ("output" + std::to_string(starts_++));
  process_ = std::make_unique<Process>(words, output);
  const bool is_there = process_->wait_for_output("\n", kStartTime);
  const std::string said = process_->output();
  BURNISH_CHECK(is_there && said.starts_with("port "), said);
  port_ = said.substr(5, said.find('\n') - 5);
  rest_ = "://127.0.0.1:" + port_;
}

S3Bucket S3Service::bucket(const S3Patience& patience) const {
  return S3Bucket(address(), credentials, patience);
}

S3Patience short_patience() {
  S3Patience patience;
  patience.silence = std::chrono::seconds(1);
  patience.quick = std::chrono::seconds(5);
  patience.pause = std::chrono::milliseconds(1);
  patience.part_bytes = 10'000;
  return patience;
}

}  // namespace burnish
