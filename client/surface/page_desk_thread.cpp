#include <condition_variable>
#include <deque>
#include <mutex>
#include <stop_token>
#include <thread>
#include <utility>

#include "client/surface/page_desk.h"

namespace burnish {
namespace {

class ThreadDesk final : public PageDesk {
 public:
  ThreadDesk(PageHead head, std::function<void()> on_news)
      : head_(std::move(head)),
        on_news_(std::move(on_news)),
        thread_([this](const std::stop_token& stop) { run(stop); }) {}

  void put(EncodedPage page) override {
    const std::lock_guard lock(mutex_);
    jobs_.push_back(std::move(page));
    changed_.notify_one();
  }

  std::vector<DecodedPage> take() override {
    const std::lock_guard lock(mutex_);
    return std::exchange(done_, {});
  }

 private:
  void run(const std::stop_token& stop) {
    std::unique_lock lock(mutex_);
    while (changed_.wait(lock, stop, [this] { return !jobs_.empty(); })) {
      const EncodedPage job = std::move(jobs_.front());
      jobs_.pop_front();
      lock.unlock();
      DecodedPage decoded = decode_in_scan(job, head_);
      lock.lock();
      done_.push_back(std::move(decoded));
      lock.unlock();
      on_news_();
      lock.lock();
    }
  }

  const PageHead head_;
  const std::function<void()> on_news_;

  std::mutex mutex_;  // guards the following members
  std::condition_variable_any changed_;
  std::deque<EncodedPage> jobs_;
  std::vector<DecodedPage> done_;

  std::jthread thread_;  // last member: it uses all the others
};

}  // namespace

std::unique_ptr<PageDesk> make_page_desk(PageHead head, std::function<void()> on_news) {
  return std::make_unique<ThreadDesk>(std::move(head), std::move(on_news));
}

}  // namespace burnish
