#include "client/pages/page_failures.h"

namespace burnish {

static int tries_max(PageItem item) {
  return item.is_of_sheets() ? PageFailures::kSheetTries : PageFailures::kTries;
}

void PageFailures::on_failure(PageItem item, const Status& why, Time now) {
  Failure& failure = failures_[item];
  if (failure.tries == tries_max(item)) return;
  failure.not_before = now + kFirstPause * (1 << failure.tries);
  if (++failure.tries == tries_max(item)) news_.push_back({item, why});
}

bool PageFailures::may_ask(PageItem item, Time now) const {
  const auto found = failures_.find(item);
  if (found == failures_.end()) return true;
  return found->second.tries < tries_max(item) && now >= found->second.not_before;
}

bool PageFailures::is_given_up(PageItem item) const {
  const auto found = failures_.find(item);
  return found != failures_.end() && found->second.tries == tries_max(item);
}

void PageFailures::clear() {
  failures_.clear();
  news_.clear();
}

}  // namespace burnish
