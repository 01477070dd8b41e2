#include <chrono>
#include <deque>
#include <utility>

#include "client/surface/page_desk.h"

namespace burnish {
namespace {

/// A part of the time between two pictures.
constexpr std::chrono::milliseconds kTurn{4};

class LoneDesk final : public PageDesk {
 public:
  LoneDesk(PageHead head, std::function<void()> on_news)
      : head_(std::move(head)), on_news_(std::move(on_news)) {}

  void put(EncodedPage page) override {
    jobs_.push_back(std::move(page));
    on_news_();
  }

  // Decodes one page at least, so that each call gets on.
  std::vector<DecodedPage> take() override {
    std::vector<DecodedPage> done;
    const auto end = std::chrono::steady_clock::now() + kTurn;
    while (!jobs_.empty() && (done.empty() || std::chrono::steady_clock::now() < end)) {
      done.push_back(decode_in_scan(jobs_.front(), head_));
      jobs_.pop_front();
    }
    if (!jobs_.empty()) on_news_();
    return done;
  }

 private:
  const PageHead head_;
  const std::function<void()> on_news_;
  std::deque<EncodedPage> jobs_;
};

}  // namespace

std::unique_ptr<PageDesk> make_page_desk(PageHead head, std::function<void()> on_news) {
  return std::make_unique<LoneDesk>(std::move(head), std::move(on_news));
}

}  // namespace burnish
