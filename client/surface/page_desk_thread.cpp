#include "client/surface/desk_thread.h"
#include "client/surface/page_desk.h"

namespace burnish {
namespace {

class ThreadDesk final : public PageDesk {
 public:
  ThreadDesk(PageHead head, std::function<void()> on_news)
      : thread_([head = std::move(head)](
                    const EncodedPage& page) { return decode_in_scan(page, head); },
                std::move(on_news)) {}

  void put(EncodedPage page) override { thread_.put(std::move(page)); }
  std::vector<DecodedPage> take() override { return thread_.take(); }

 private:
  DeskThread<EncodedPage, DecodedPage> thread_;
};

}  // namespace

std::unique_ptr<PageDesk> make_page_desk(PageHead head, std::function<void()> on_news) {
  return std::make_unique<ThreadDesk>(std::move(head), std::move(on_news));
}

}  // namespace burnish
