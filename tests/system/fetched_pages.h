#pragma once

#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "client/connection/connection.h"
#include "client/live/live_link.h"
#include "common/pages/directory.h"

namespace burnish {

/// All pages of a scan, as a client fetches them.
struct FetchedPages {
  using Shared = std::vector<std::shared_ptr<const Page>>;

  PageHead head;
  uint64_t fingerprint = 0;
  Shared pages;  ///< by number

  Shared level(int level) const;

  /// Returns the options of a link to a session of the scan.
  LiveOptions live_options(const std::string& session, int depth) const;
  /// Units: file.
  double cell_size(int depth) const { return std::ldexp(head.grid.side, -depth); }
};

/// Ends the program if anything does not come.
FetchedPages fetch_all_pages(Connection& connection, const std::string& scan);

}  // namespace burnish
