#include "client/model/documents/sheet_finder.h"

#include <string_view>
#include <utility>

namespace burnish {

void SheetFinder::find(const SeamsOfSession& seams) {
  const bool is_other = seams_ != seams;
  seams_ = seams;
  if (!is_finding()) return start();
  if (is_other) outdated_->store(true);
}

void SheetFinder::start() {
  outdated_ = std::make_shared<std::atomic<bool>>(false);
  tasks_.start([this, alive = std::weak_ptr(alive_), describe = describe_, seams = *seams_,
                outdated = outdated_](const StopToken& stop) -> Tasks::Completion {
    const auto goes_on = [&](std::string_view, double) {
      return !stop.stop_requested() && !outdated->load();
    };
    const auto found = describe(seams, goes_on);
    return [this, alive, found] {
      if (!alive.expired()) end(found);
    };
  });
}

// Sheets that were found before their cancel was heard are newer than those shown.
void SheetFinder::end(const Result<SheetsDescription>& found) {
  const bool is_outdated = std::exchange(outdated_, nullptr)->load();
  if (is_outdated) start();
  if (found.is_ok() || !is_outdated) take_(found);
}

}  // namespace burnish
