#pragma once

#include <filesystem>
#include <vector>

#include "client/model/settings/recent_sessions.h"
#include "client/scene/image.h"

namespace burnish {

// Small pictures of the recent sessions, in a folder of this user alone: one per session, at most
// kRecentMax.

inline constexpr ImageSize kSessionPictureSize{256, 160};

/// Returns the middle of a picture in this size. Needs: sides that are not smaller.
Image shrunk(const Image& image, const ImageSize& size);

/// Returns the file of a session's picture; empty if the session's id is not that of a server.
std::filesystem::path picture_path(const std::filesystem::path& folder,
                                   const RecentSession& session);

/// Keeps a picture of the session, and removes those of sessions that are not in `recent`. A
/// picture that is smaller than kSessionPictureSize is not kept. Fails: as make_private_folder()
/// and write_png() do.
Status keep_picture(const std::filesystem::path& folder, const RecentSession& session,
                    const Image& image, const std::vector<RecentSession>& recent);

}  // namespace burnish
