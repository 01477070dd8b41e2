// client/model/workspace/session_pictures.h where the page's store keeps the pictures.

#include <algorithm>

#include "client/model/workspace/session_pictures.h"
#include "client/web/core/host/imports.h"
#include "client/web/core/host/store.h"
#include "common/base/text_lines.h"

namespace burnish {

namespace {

constexpr const char* kList = "pictures";  // ids of the sessions that have one

std::string key_of(std::string_view session) {
  return "picture/" + std::string(session);
}

void drop_others(const std::string& session, const std::vector<RecentSession>& recent) {
  std::string kept = session;
  const std::string list = stored_text(kList);
  for (const TextLine& line : split_lines(list))
    for (const std::string_view each : line.words) {
      if (each == session) continue;
      if (std::ranges::find(recent, each, &RecentSession::id) == recent.end()) {
        store_text(key_of(each), "");
      } else {
        kept += " " + std::string(each);
      }
    }
  store_text(kList, kept);
}

}  // namespace

Status keep_picture(const std::filesystem::path& folder, const RecentSession& session,
                    const Image& image, const std::vector<RecentSession>& recent) {
  const bool is_large = image.size.width >= kSessionPictureSize.width &&
                        image.size.height >= kSessionPictureSize.height;
  if (picture_path(folder, session).empty() || !is_large) return Status::ok();
  drop_others(session.id, recent);
  const Image small = shrunk(image, kSessionPictureSize);
  const std::string key = key_of(session.id);
  host_picture_keep(key.data(), key.size(), small.rgb.data(), small.size.width, small.size.height);
  return Status::ok();
}

}  // namespace burnish
