#include "server/s3/curl_handle.h"

#include <algorithm>

namespace burnish {

CurlHandle::CurlHandle() {
  static const CURLcode is_ready = curl_global_init(CURL_GLOBAL_DEFAULT);
  BURNISH_CHECK(is_ready == CURLE_OK, "libcurl does not start");
  handle_.reset(curl_easy_init());
  BURNISH_CHECK(handle_ != nullptr, "libcurl has no memory");
}

void CurlHandle::add_header(const std::string& line) {
  curl_slist* longer = curl_slist_append(headers_.get(), line.c_str());
  BURNISH_CHECK(longer != nullptr, "libcurl has no memory");
  (void)headers_.release();
  headers_.reset(longer);
}

std::string CurlHandle::perform() {
  char words[CURL_ERROR_SIZE] = "";
  set(CURLOPT_HTTPHEADER, headers_.get());
  set(CURLOPT_ERRORBUFFER, words);
  const CURLcode code = curl_easy_perform(handle_.get());
  set(CURLOPT_ERRORBUFFER, nullptr);
  if (code == CURLE_OK) return {};
  return words[0] != '\0' ? words : curl_easy_strerror(code);
}

int CurlHandle::status() const {
  long status = 0;
  curl_easy_getinfo(handle_.get(), CURLINFO_RESPONSE_CODE, &status);
  return static_cast<int>(status);
}

std::string CurlHandle::header(const char* name) const {
  curl_header* found = nullptr;
  const CURLHcode code = curl_easy_header(handle_.get(), name, 0, CURLH_HEADER, -1, &found);
  return code == CURLHE_OK ? found->value : "";
}

uint64_t CurlHandle::content_length() const {
  curl_off_t length = 0;
  curl_easy_getinfo(handle_.get(), CURLINFO_CONTENT_LENGTH_DOWNLOAD_T, &length);
  return static_cast<uint64_t>(std::max<curl_off_t>(length, 0));
}

}  // namespace burnish
