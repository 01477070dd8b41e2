#pragma once

#include <string>
#include <vector>

#include "common/base/status.h"

namespace burnish {

/// The address of a database: a connection URI of libpq without a password. A URI may name several
/// hosts, of which one at a time takes writes.
class PgAddress {
 public:
  /// Fails: invalid_argument for text that is not such a URI, and for a password in it. The message
  /// does not repeat the text.
  static Result<PgAddress> parse(const std::string& uri);

  struct Host {
    std::string name, port;  ///< empty: as libpq chooses
  };

  const std::string& uri() const { return uri_; }
  /// Returns the hosts in the order of the URI; one without a name if the URI names none.
  const std::vector<Host>& hosts() const { return hosts_; }

 private:
  std::string uri_;
  std::vector<Host> hosts_;
};

/// Returns whether the text names a database by its scheme.
bool is_pg_uri(const std::string& text);

}  // namespace burnish
