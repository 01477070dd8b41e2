#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

struct XXH3_state_s;

namespace burnish {

/// Sums up a row's values, types included, in the order in which they come. All journals have the
/// same sums.
class RowChecksum {
 public:
  RowChecksum();

  void add(int64_t value);
  void add(double value);  ///< -0 counts as 0
  void add(std::string_view bytes);
  void add_text(std::string_view text);
  void add_null();

  /// Returns 16 bytes, and begins anew.
  std::string take();

 private:
  struct Free {
    void operator()(XXH3_state_s* state) const;
  };
  template <typename T>
  void add_raw(const T& value);
  void add_sized(std::string_view bytes);
  std::unique_ptr<XXH3_state_s, Free> state_;
};

/// Returns the checksum of a row of these values.
template <typename... Values>
std::string row_checksum_of(const Values&... values) {
  RowChecksum sum;
  (sum.add(values), ...);
  return sum.take();
}

}  // namespace burnish
