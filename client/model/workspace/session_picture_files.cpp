// The part of session_pictures.h that keeps pictures in files.

#include <algorithm>

#include "client/model/files/private_folder.h"
#include "client/model/workspace/session_pictures.h"
#include "client/scene/png_writer.h"

namespace burnish {

namespace fs = std::filesystem;

static void remove_others(const fs::path& folder, const std::vector<RecentSession>& recent) {
  std::error_code ignored;
  for (const auto& file : fs::directory_iterator(folder, ignored)) {
    const bool is_wanted = std::any_of(
        recent.begin(), recent.end(),
        [&](const RecentSession& each) { return picture_path(folder, each) == file.path(); });
    if (!is_wanted && file.path().extension() == ".png") fs::remove(file.path(), ignored);
  }
}

Status keep_picture(const fs::path& folder, const RecentSession& session, const Image& image,
                    const std::vector<RecentSession>& recent) {
  const fs::path path = picture_path(folder, session);
  const bool is_large = image.size.width >= kSessionPictureSize.width &&
                        image.size.height >= kSessionPictureSize.height;
  if (path.empty() || !is_large) return Status::ok();
  RETURN_IF_ERROR(make_private_folder(folder));
  remove_others(folder, recent);
  return write_png(shrunk(image, kSessionPictureSize), path);
}

}  // namespace burnish
