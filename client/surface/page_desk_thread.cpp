#include <utility>

#include "client/surface/desk_thread.h"
#include "client/surface/page_desk.h"

namespace burnish {

std::unique_ptr<PageDesk> make_page_desk(PageHead head, std::function<void()> on_news) {
  return std::make_unique<DeskThread<EncodedPage, DecodedPage>>(
      [head = std::move(head)](const EncodedPage& page) { return decode_in_scan(page, head); },
      std::move(on_news));
}

}  // namespace burnish
