#pragma once

#include <memory>
#include <string>
#include <string_view>

namespace burnish {

/// Computes the SHA-256 of a file's bytes as they pass. It identifies a scan.
class ContentHash {
 public:
  static constexpr size_t kDigits = 64;

  ContentHash();
  ~ContentHash();
  ContentHash(ContentHash&&) noexcept;
  ContentHash& operator=(ContentHash&&) noexcept;

  void update(std::string_view bytes);

  /// Returns 64 lower-case hexadecimal digits. Ends the hash: call it once.
  std::string finish();

 private:
  struct Context;
  std::unique_ptr<Context> context_;
};

/// Returns true for 64 lower-case hexadecimal digits.
bool is_content_hash(std::string_view text);

}  // namespace burnish
