#include "server/postgres/pg_address.h"

#include <algorithm>
#include <memory>
#include <string_view>

#include <libpq-fe.h>

namespace burnish {
namespace {

struct FreeOptions {
  void operator()(PQconninfoOption* options) const { PQconninfoFree(options); }
};

std::string value_of(const PQconninfoOption* options, std::string_view keyword) {
  for (; options->keyword; ++options)
    if (options->keyword == keyword && options->val) return options->val;
  return {};
}

std::vector<std::string> split(const std::string& list) {
  std::vector<std::string> parts(1);
  for (const char c : list) {
    if (c == ',') {
      parts.emplace_back();
    } else {
      parts.back() += c;
    }
  }
  return parts;
}

}  // namespace

bool is_pg_uri(const std::string& text) {
  return text.starts_with("postgresql://") || text.starts_with("postgres://");
}

Result<PgAddress> PgAddress::parse(const std::string& uri) {
  if (!is_pg_uri(uri))
    return invalid_argument("the journal's address does not begin with postgresql://");
  char* problem = nullptr;
  const std::unique_ptr<PQconninfoOption, FreeOptions> options(
      PQconninfoParse(uri.c_str(), &problem));
  PQfreemem(problem);  // repeats the URI, which may have a password in the wrong place
  if (!options)
    return invalid_argument(
        "the journal's address is not a connection URI of PostgreSQL, such as "
        "postgresql://burnish@db.lab:5432/burnish");
  if (!value_of(options.get(), "password").empty())
    return invalid_argument(
        "the journal's address has a password; leave it to ~/.pgpass, PGPASSFILE or a service "
        "file");
  PgAddress address;
  address.uri_ = uri;
  const auto names = split(value_of(options.get(), "host"));
  const auto ports = split(value_of(options.get(), "port"));
  for (size_t i = 0; i < names.size(); ++i)
    address.hosts_.push_back({names[i], ports[std::min(i, ports.size() - 1)]});
  return address;
}

}  // namespace burnish
