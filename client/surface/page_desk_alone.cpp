#include <algorithm>
#include <chrono>
#include <deque>
#include <utility>

#include "client/surface/page_desk.h"

namespace burnish {
namespace {

using std::chrono::steady_clock;

/// Decoding takes a third of the time since the last turn, or this: slow pictures are few, and must
/// not make decoding slow too.
constexpr steady_clock::duration kTurnMin = std::chrono::milliseconds(4);

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
    const steady_clock::time_point begin = steady_clock::now();
    const steady_clock::time_point end = begin + std::max(kTurnMin, (begin - ended_at_) / 3);
    while (!jobs_.empty() && (done.empty() || steady_clock::now() < end)) {
      done.push_back(decode_in_scan(jobs_.front(), head_));
      jobs_.pop_front();
    }
    ended_at_ = steady_clock::now();
    if (!jobs_.empty()) on_news_();
    return done;
  }

 private:
  const PageHead head_;
  const std::function<void()> on_news_;
  std::deque<EncodedPage> jobs_;
  steady_clock::time_point ended_at_;  // the last turn
};

}  // namespace

std::unique_ptr<PageDesk> make_page_desk(PageHead head, std::function<void()> on_news) {
  return std::make_unique<LoneDesk>(std::move(head), std::move(on_news));
}

}  // namespace burnish
