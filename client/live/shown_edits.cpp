#include "client/live/shown_edits.h"

#include <algorithm>

#include "common/base/clock.h"

namespace burnish {

static constexpr size_t kLevelsKept = 64;     // frames between an edit's frame and its answer
static constexpr size_t kPreviewsKept = 256;  // not shown yet

void ShownEdits::acknowledged(std::vector<std::string> ids, Time since, uint64_t edits) {
  const auto level =
      std::ranges::find_if(levels_, [&](const Level& l) { return l.edits >= edits; });
  if (level == levels_.end()) {
    waiting_.push_back({std::move(ids), since, edits});
  } else {
    // A frame that was there before the edit was made had it: it had been applied before.
    shown_.push_back({std::move(ids), std::max(0.0, ms_between(since, level->when))});
  }
}

void ShownEdits::preview_sent(uint64_t count, Time since) {
  has_previewed_ = true;
  previews_.push_back({count, since});
  if (previews_.size() > kPreviewsKept) previews_.pop_front();
}

void ShownEdits::frame(uint64_t edits, uint64_t previews, Time now) {
  if (levels_.empty() || edits > levels_.back().edits) levels_.push_back({edits, now});
  if (levels_.size() > kLevelsKept) levels_.pop_front();
  std::erase_if(waiting_, [&](Waiting& waiting) {
    if (waiting.edits > edits) return false;
    shown_.push_back({std::move(waiting.ids), ms_between(waiting.since, now)});
    return true;
  });
  is_frame_old_ = false;
  for (; !previews_.empty() && previews_.front().count <= previews; previews_.pop_front())
    preview_ms_.push_back(ms_between(previews_.front().since, now));
}

void ShownEdits::restart() {
  is_frame_old_ = has_previewed_;
  previews_.clear();
}

std::vector<EditsShown> ShownEdits::take_edits() {
  return std::exchange(shown_, {});
}

std::vector<double> ShownEdits::take_previews() {
  return std::exchange(preview_ms_, {});
}

}  // namespace burnish
