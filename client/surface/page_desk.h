#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "client/scene/page_mesh.h"
#include "client/surface/desk.h"
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

using PageDesk = Desk<EncodedPage, DecodedPage>;

/// `on_news`: take() has something; called from any thread.
std::unique_ptr<PageDesk> make_page_desk(PageHead head, std::function<void()> on_news);

}  // namespace burnish
