#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "client/scene/page_mesh.h"
#include "common/pages/directory.h"

namespace burnish {

struct EncodedPage {
  PageId id = 0;
  std::vector<uint8_t> bytes;
};

struct DecodedPage {
  PageId id = 0;
  Result<Page> page;
  PageMesh mesh;  ///< empty if the page failed
};

/// Decodes a page of a scan, and checks that it fits there.
DecodedPage decode_in_scan(const EncodedPage& encoded, const PageHead& head);

/// Where pages are decoded: on a thread of its own (page_desk_thread.cpp), or between two pictures
/// where there are no threads (page_desk_alone.cpp). Used from one thread.
class PageDesk {
 public:
  PageDesk() = default;
  virtual ~PageDesk() = default;
  PageDesk(const PageDesk&) = delete;
  PageDesk& operator=(const PageDesk&) = delete;

  virtual void put(EncodedPage page) = 0;
  /// Returns the pages that are done since the last call.
  virtual std::vector<DecodedPage> take() = 0;
};

/// `on_news`: take() has something; called from any thread.
std::unique_ptr<PageDesk> make_page_desk(PageHead head, std::function<void()> on_news);

}  // namespace burnish
