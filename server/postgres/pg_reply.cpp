#include "server/postgres/pg_reply.h"

#include <bit>
#include <charconv>
#include <string_view>

#include <libpq-fe.h>

namespace burnish {

void PgReply::Clear::operator()(pg_result* result) const {
  PQclear(result);
}

size_t PgReply::rows() const {
  return static_cast<size_t>(PQntuples(result_.get()));
}

uint64_t PgReply::affected() const {
  const std::string_view text = PQcmdTuples(result_.get());
  uint64_t count = 0;
  std::from_chars(text.data(), text.data() + text.size(), count);
  return count;
}

std::string PgReply::bytes(size_t row, size_t column) const {
  const int r = static_cast<int>(row), c = static_cast<int>(column);
  return {PQgetvalue(result_.get(), r, c), static_cast<size_t>(PQgetlength(result_.get(), r, c))};
}

// Numbers travel in network order.
static uint64_t big_endian(const std::string& bytes) {
  uint64_t value = 0;
  for (const char byte : bytes) value = value << 8 | static_cast<uint8_t>(byte);
  return value;
}

int64_t PgReply::integer(size_t row, size_t column) const {
  const std::string value = bytes(row, column);
  const auto bits = big_endian(value);
  if (value.size() == sizeof(int32_t)) return static_cast<int32_t>(bits);
  return static_cast<int64_t>(bits);
}

double PgReply::real(size_t row, size_t column) const {
  return std::bit_cast<double>(big_endian(bytes(row, column)));
}

}  // namespace burnish
