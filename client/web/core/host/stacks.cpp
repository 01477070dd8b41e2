#include "client/web/core/host/stacks.h"

#include <cstdint>
#include <cstring>
#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "client/web/core/host/exports.h"
#include "client/web/core/host/imports.h"
#include "common/base/check.h"

namespace burnish {

namespace {

// Replayed scripts decode pages and draw on a stack of their own.
constexpr size_t kStackBytes = 1 << 20;
constexpr size_t kStacksKept = 8;  // for the next ones
constexpr uint64_t kMark = 0x6275726e6973680a;

/// The memory that a stack's values take. It grows down; a mark lies at its end.
class StackMemory {
 public:
  StackMemory() : bytes_(new uint64_t[kStackBytes / sizeof(uint64_t)]) { bytes_[0] = kMark; }
  uint8_t* top() const { return reinterpret_cast<uint8_t*>(bytes_.get()) + kStackBytes; }
  bool is_whole() const { return bytes_[0] == kMark; }

 private:
  std::unique_ptr<uint64_t[]> bytes_;
};

struct Stack {
  std::function<void()> work;
  StackMemory memory;
};

struct Stacks {
  std::map<int, Stack> all;
  std::vector<StackMemory> spare;
  int last = 0;
  int running = 0;
};

Stacks& stacks() {
  static Stacks* const the = new Stacks();  // lives as long as the page
  return *the;
}

}  // namespace

void start_stack(std::function<void()> work) {
  Stacks& the = stacks();
  const int number = ++the.last;
  StackMemory memory = the.spare.empty() ? StackMemory() : std::move(the.spare.back());
  if (!the.spare.empty()) the.spare.pop_back();
  the.all.emplace(number, Stack{std::move(work), std::move(memory)});
  host_task_start(number);
}

int this_stack() {
  return stacks().running;
}

void wait_on_stack() {
  const int me = std::exchange(stacks().running, 0);
  BURNISH_CHECK(me != 0, "only stacks of their own wait");
  host_task_suspend(me);
  stacks().running = me;
}

void resume_stack(int stack) {
  if (stack != 0) host_task_resume(stack);
}

}  // namespace burnish

using burnish::stacks;

uint8_t* core_stack(int task) {
  return stacks().all.at(task).memory.top();
}

void core_task(int task) {
  stacks().running = task;
  {
    const auto work = std::move(stacks().all.at(task).work);
    work();
  }
  stacks().running = 0;
  burnish::StackMemory memory = std::move(stacks().all.at(task).memory);
  BURNISH_CHECK(memory.is_whole(), "a stack of its own has room for the work on it");
  stacks().all.erase(task);
  if (stacks().spare.size() < burnish::kStacksKept) stacks().spare.push_back(std::move(memory));
}
