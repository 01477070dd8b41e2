#pragma once

#include <cstdint>
#include <vector>

#include "client/pages/page_loader.h"
#include "common/pages/page_file.h"

namespace burnish {

/// A client's pages without a server: whatever a picture asks for comes at once from a page file.
class LocalPages {
 public:
  explicit LocalPages(PageFile file);

  const PageHead& head() const { return file_.directory().head; }
  const PageLoader& loader() const { return loader_; }

  /// Chooses the cut of a picture, and hands in all that it asks for. Returns the pages that have a
  /// new slot. Fails: as reading and decoding do.
  Result<std::vector<PageUpload>> look(const PageView& view);

  /// Returns the bytes of all pages and blocks that were handed in.
  uint64_t bytes() const { return bytes_; }

 private:
  Status bring(PageItem item);

  PageFile file_;
  PageLoader loader_;
  uint64_t bytes_ = 0;
};

}  // namespace burnish
