#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace burnish {

/// Text, where a statement needs `text` and not `bytea`.
struct PgText {
  std::string text;
};

/// A value of a statement: bytes are a `bytea`, numbers are `bigint` and `double precision`.
using PgValue = std::variant<std::string, int64_t, double, PgText>;

/// One SQL command, and the values of $1, $2, ... in it.
struct PgStatement {
  std::string sql;
  std::vector<PgValue> values;
};

}  // namespace burnish
