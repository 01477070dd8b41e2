#include "client/model/workspace.h"

namespace burnish {

// The folder of the preferences keeps views, if there is one.
static std::filesystem::path views_file(const std::filesystem::path& preferences) {
  return preferences.empty() ? preferences
                             : std::filesystem::path(preferences).replace_filename("views.toml");
}

std::optional<ViewState> Workspace::kept_view(const std::string& session) const {
  const std::filesystem::path file = views_file(options_.preferences);
  return file.empty() ? std::nullopt : read_view(file, {recent_server(), session});
}

void Workspace::see_as_kept(const std::string& session) {
  const auto view = kept_view(session);
  if (!view) return;
  viewport.camera = view->camera;
  viewport.options = view->options;
}

// The camera of a raw scan that the session takes over stays: the user may have turned it.
void Workspace::restore_view(bool keeps_camera) {
  auto view = kept_view(document_->session().id);
  if (!view) return;
  if (!keeps_camera) viewport.camera = view->camera;
  viewport.options = view->options;
  viewport.bookmarks = std::move(view->bookmarks);
  if (view->colour != ColourBy::kScan || document_->has_colours())
    document_->set_colour(view->colour);
}

void Workspace::record_picture(const std::filesystem::path& file) {
  recorder.record("wait");
  recorder.record(viewport.camera);
  for (const std::string& line : script_lines(viewport.options.lighting)) recorder.record(line);
  recorder.record("screenshot " + file.string());
}

void Workspace::save_view() {
  const std::filesystem::path file = views_file(options_.preferences);
  if (file.empty()) return;
  const ViewKey key{document_server_, document_->session().id};
  const Status written = write_view(
      file, key, {viewport.camera, viewport.options, document_->colour(), viewport.bookmarks});
  if (!written.is_ok()) log.failure("views", written);
}

}  // namespace burnish
