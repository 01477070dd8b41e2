// The part of Workspace that shows a file before a server has it. A browser has none of this.

#include <utility>

#include "client/model/workspace/workspace.h"

namespace burnish {

static std::shared_ptr<Activity> raw_activity(const std::filesystem::path& file,
                                              uint64_t triangles) {
  return std::make_shared<Activity>("Opening " + file.filename().string(), opening_plan(triangles));
}

// Reads the file before anything else, so that its surface is seen at once.
void Workspace::show_raw_and_import(const std::filesystem::path& file, Opening opening) {
  raw_file_ = file;
  if (!connection_ && library_.state != Library::State::kConnecting) connect_privately();
  const auto reading = std::make_shared<Activity>("Reading " + file.filename().string());
  start_activity(reading, [this, file, opening, reading](const Progress&) {
    auto read = std::make_shared<Result<RawScan>>(read_raw_scan(file, options_.budget.triangles));
    return [this, file, opening, reading, read] {
      if (reading->is_cancelled()) *read = cancelled("the import was cancelled");
      take_raw(file, opening, std::move(*read));
    };
  });
}

void Workspace::take_raw(const std::filesystem::path& file, Opening opening, Result<RawScan> read) {
  if (!read.is_ok()) {
    close_raw(file);
    return log.failure("import of " + file.string(), read.status());
  }
  const uint64_t triangles = read->triangles;
  if (raw_file_ == file && may_open(file) && put_into(renderer_, *read).is_ok()) {
    raw_ = std::move(*read);
    raw_opening_ = opening;
    ++pictures_begun_;
    viewport.begin(raw_->box, raw_->up);
    return open_raw();
  }
  const auto activity = raw_activity(file, triangles);
  when_connected([this, file, opening, activity] { import_there(file, opening, activity); });
}

void Workspace::open_raw() {
  raw_work_ = raw_activity(raw_file_, raw_->triangles);
  when_connected([this, file = raw_file_, opening = raw_opening_, work = raw_work_] {
    import_there(file, opening, work);
  });
}

// The server has one session to prepare at a time: the running one ends first.
void Workspace::choose_depth(int depth) {
  if (!raw_work_ || !raw_ || std::exchange(raw_depth_, depth) == depth) return;
  raw_begins_again_ = true;
  raw_work_->cancel();
}

/// Returns whether the work that has ended begins again at another depth.
bool Workspace::begins_again() {
  if (!raw_ || !std::exchange(raw_begins_again_, false)) return false;
  open_raw();
  return true;
}

}  // namespace burnish
