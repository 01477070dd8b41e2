#include "client/model/workspace.h"

namespace burnish {

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
  if (!document_ && raw_file_ == file && put_into(renderer_, *read).is_ok()) {
    raw_ = std::move(*read);
    ++pictures_begun_;
    viewport.begin(raw_->box);
  }
  const auto activity =
      std::make_shared<Activity>("Opening " + file.filename().string(), opening_plan(triangles));
  when_connected([this, file, opening, activity] { import_there(file, opening, activity); });
}

void Workspace::close_raw(const std::filesystem::path& file) {
  if (raw_file_ == file) forget_raw();
}

void Workspace::forget_raw() {
  raw_file_.clear();
  raw_.reset();
}

bool Workspace::may_open(const std::filesystem::path& file) const {
  return !document_ && !opening_ && (raw_file_.empty() || raw_file_ == file);
}

Status Workspace::draw() {
  is_drawn_ = document_ != nullptr;
  if (document_) return viewport.draw(renderer_, *document_);
  if (!raw_) return Status::ok();
  DrawStyle style = style_of(*raw_);
  style.lighting = viewport.options.lighting;
  return renderer_.draw(viewport.camera, viewport.size(), style, raw_->patches);
}

}  // namespace burnish
