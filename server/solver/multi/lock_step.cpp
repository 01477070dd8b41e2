#include "server/solver/multi/lock_step.h"

#include <algorithm>
#include <utility>

#include "common/base/check.h"
#include "common/base/parallel.h"

namespace burnish {

namespace {

// The steps of which this thread does a shard's work, and the shard.
thread_local const LockStep* working_for = nullptr;
thread_local int working_as = -1;

}  // namespace

LockStep::LockStep(int shards) {
  for (int shard = 0; shard < shards; ++shard) slots_.push_back(std::make_unique<Slot>());
  for (int shard = 1; shard < shards; ++shard)
    slots_[shard]->thread = std::jthread([this, shard] { serve(shard); });
}

LockStep::~LockStep() {
  is_over_ = true;
  for (const auto& slot : slots_) slot->turn.release();
}

int LockStep::current() const {
  return working_for == this ? working_as : -1;
}

void LockStep::serve(int shard) {
  for (;;) {
    slots_[shard]->turn.acquire();
    if (is_over_) return;
    use_threads(threads_);
    work_as(shard);
  }
}

void LockStep::run(const std::function<void(int)>& work) {
  BURNISH_CHECK(current() == -1, "work of shards does not nest");
  work_ = &work;
  arrived_ = 0;
  threads_ = thread_count();
  for (const auto& slot : slots_) slot->has_ended = false;
  work_as(0);
  // The last turn of all comes back here.
  if (shards() > 1) slots_[0]->turn.acquire();
}

void LockStep::work_as(int shard) {
  const LockStep* outer = std::exchange(working_for, this);
  const int outer_shard = std::exchange(working_as, shard);
  (*work_)(shard);
  working_for = outer;
  working_as = outer_shard;
  slots_[shard]->has_ended = true;
  if (shards() > 1) hand_on(shard);
}

void LockStep::arrive_and_wait(const std::function<void()>& together) {
  if (shards() == 1) return together();
  const int shard = working_as;
  together_ = &together;
  ++arrived_;
  hand_on(shard);
  slots_[shard]->turn.acquire();
}

// Gives the turn to the next shard that works. The last one of a round ends the round first.
void LockStep::hand_on(int shard) {
  const auto works = [&](int other) { return !slots_[other]->has_ended; };
  int next = shard + 1;
  while (next < shards() && !works(next)) ++next;
  if (next < shards()) return slots_[next]->turn.release();
  if (std::exchange(arrived_, 0) == shards()) (*together_)();
  next = 0;
  while (next < shards() && !works(next)) ++next;
  slots_[next < shards() ? next : 0]->turn.release();
}

}  // namespace burnish
