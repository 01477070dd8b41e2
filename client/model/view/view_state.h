#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "client/model/view/viewport.h"

namespace burnish {

inline constexpr size_t kViewsMax = 100;  // sessions whose views are kept

/// How a user last saw a session.
struct ViewState {
  std::string scan;  ///< id; empty: not kept
  Camera camera;
  ViewOptions options;
  ColourBy colour = ColourBy::kNothing;
  std::vector<Camera> bookmarks;

  bool operator==(const ViewState&) const = default;
};

/// A session on a server.
struct ViewKey {
  std::string server;   ///< empty: the private server of this computer
  std::string session;  ///< id

  bool operator==(const ViewKey&) const = default;
};

/// Returns nothing for a session that the file does not know, and for a damaged file or entry.
std::optional<ViewState> read_view(const std::filesystem::path& file, const ViewKey& key);

/// Returns the axis that pointed up when a session of the scan was seen last.
std::optional<UpAxis> read_up(const std::filesystem::path& file, const std::string& scan);

/// Puts the session first in the file and drops the oldest ones beyond kViewsMax. Keeps the first
/// kBookmarksMax bookmarks. A damaged file is replaced. Fails: as errno says.
Status write_view(const std::filesystem::path& file, const ViewKey& key, const ViewState& view);

}  // namespace burnish
