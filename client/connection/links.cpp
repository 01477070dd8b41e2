#include "client/connection/links.h"

#include "client/connection/page_fetcher.h"
#include "client/connection/session_link.h"

namespace burnish {

std::unique_ptr<LiveLink> make_live_link(const Connection& connection, LiveOptions options) {
  return std::make_unique<SessionLink>(connection, std::move(options));
}

std::unique_ptr<PageSource> make_page_source(const Connection& connection, FetchedPages pages) {
  return std::make_unique<PageFetcher>(connection, std::move(pages.scan), std::move(pages.on_news),
                                       std::make_shared<PageDisk>(pages.folder, pages.fingerprint));
}

}  // namespace burnish
