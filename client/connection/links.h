#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>

#include "client/connection/connection.h"
#include "client/live/live_link.h"
#include "client/pages/page_source.h"

namespace burnish {

// Makes what carries an open session besides calls. Both outlive the connection.

/// Begins a live session: a SessionLink, or in a browser its like.
std::unique_ptr<LiveLink> make_live_link(const Connection& connection, LiveOptions options);

/// Pages that are to be fetched.
struct FetchedPages {
  std::string scan;               ///< id
  uint64_t fingerprint = 0;       ///< pages_fingerprint() of the scan's encoded head
  std::filesystem::path folder;   ///< keeps fetched pages; empty: none. Not in a browser
  std::function<void()> on_news;  ///< from any thread: there is something to take; must not block
};

/// Returns a PageFetcher, or in a browser its like.
std::unique_ptr<PageSource> make_page_source(const Connection& connection, FetchedPages pages);

}  // namespace burnish
