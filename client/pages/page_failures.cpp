#include "client/pages/page_failures.h"

namespace burnish {

void PageFailures::on_failure(PageItem item, const Status& why, Time now) {
  Failure& failure = failures_[item];
  if (failure.tries == kTries) return;
  failure.not_before = now + kFirstPause * (1 << failure.tries);
  if (++failure.tries == kTries) news_.push_back({item, why});
}

bool PageFailures::may_ask(PageItem item, Time now) const {
  const auto found = failures_.find(item);
  if (found == failures_.end()) return true;
  return found->second.tries < kTries && now >= found->second.not_before;
}

bool PageFailures::is_given_up(PageItem item) const {
  const auto found = failures_.find(item);
  return found != failures_.end() && found->second.tries == kTries;
}

void PageFailures::clear() {
  failures_.clear();
  news_.clear();
}

}  // namespace burnish
