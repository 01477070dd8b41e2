#pragma once

#include <cstdint>
#include <memory>
#include <string>

struct pg_result;

namespace burnish {

/// The rows that a statement returned. Rows and columns count from 0.
class PgReply {
 public:
  explicit PgReply(pg_result* result) : result_(result) {}

  size_t rows() const;

  /// Returns how many rows the statement changed.
  uint64_t affected() const;

  std::string bytes(size_t row, size_t column) const;  ///< of bytea and text; "" for NULL
  int64_t integer(size_t row, size_t column) const;    ///< of integer, bigint and boolean
  double real(size_t row, size_t column) const;        ///< of double precision

 private:
  struct Clear {
    void operator()(pg_result* result) const;
  };
  std::unique_ptr<pg_result, Clear> result_;
};

}  // namespace burnish
