#include "tests/system/fetched_pages.h"

#include "common/base/check.h"
#include "common/pages/directory_codec.h"
#include "common/pages/page_codec.h"

namespace burnish {

FetchedPages::Shared FetchedPages::level(int level) const {
  return {pages.begin() + head.level_begin(level), pages.begin() + head.level_begin(level + 1)};
}

LiveOptions FetchedPages::live_options(const std::string& session, int depth) const {
  LiveOptions options;
  options.greeting.session = session;
  options.head = head;
  options.depth = depth;
  options.pages_fingerprint = fingerprint;
  return options;
}

FetchedPages fetch_all_pages(Connection& connection, const std::string& scan) {
  const PagesDescription description = connection.describe_pages(scan, {}).value();
  FetchedPages fetched;
  fetched.head = decode_head(description.head).value();
  fetched.fingerprint = pages_fingerprint(description.head);
  const auto take = [&](const PagePart& part) {
    fetched.pages.push_back(std::make_shared<const Page>(decode_page(part.bytes).value()));
    return true;
  };
  for (PageId page = 0; page < fetched.head.page_count();) {
    PagesWish wish{scan, {}, {}};
    while (page < fetched.head.page_count() && wish.pages.size() < kPagePartsPerFetchMax)
      wish.pages.push_back(page++);
    const Status status = connection.fetch_pages(wish, {{}, take});
    BURNISH_CHECK(status.is_ok(), status.message());
  }
  return fetched;
}

}  // namespace burnish
