#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include <curl/curl.h>

#include "common/base/check.h"

namespace burnish {

/// One transfer of libcurl, with its headers.
class CurlHandle {
 public:
  CurlHandle();

  template <typename Value>
  void set(CURLoption option, Value value) {
    const CURLcode code = curl_easy_setopt(handle_.get(), option, value);
    BURNISH_CHECK(code == CURLE_OK, curl_easy_strerror(code));
  }
  /// `line`: "NAME: VALUE". libcurl 7.88 signs each header of these, also one that takes a header
  /// of its own away and is not sent.
  void add_header(const std::string& line);

  /// Returns "", or why there is no whole answer.
  std::string perform();

  /// Return what has come so far: the status of HTTP, a header, Content-Length.
  int status() const;
  std::string header(const char* name) const;
  uint64_t content_length() const;

 private:
  struct EndHandle {
    void operator()(CURL* handle) const { curl_easy_cleanup(handle); }
  };
  struct EndList {
    void operator()(curl_slist* list) const { curl_slist_free_all(list); }
  };

  std::unique_ptr<curl_slist, EndList> headers_;
  std::unique_ptr<CURL, EndHandle> handle_;
};

}  // namespace burnish
