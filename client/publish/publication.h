#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "client/connection/connection.h"

namespace burnish {

/// A wish for a publication.
struct PublishWish {
  std::string session;  ///< name or id
  std::filesystem::path folder;
  std::string title;     ///< empty: the session's name
  std::string credit;    ///< who made it, and its licence; empty: nothing is said
  bool replace = false;  ///< an earlier publication in the folder
};

struct Publication {
  uint64_t files = 0;
  uint64_t bytes = 0;  ///< of all files
  uint64_t pages = 0;
  uint64_t triangles = 0;
  bool has_textures = false;
};

/// Checks a title or a credit: at most kPublishedTextBytesMax bytes of UTF-8 without control
/// characters. Fails: invalid_argument that begins with `what`.
Status check_published_text(const std::string& what, const std::string& text);

inline constexpr size_t kPublishedTextBytesMax = 1000;

/// Writes a folder that any web server or object store can show: the page's viewer, and the
/// session's surface before and after its edits, at all levels of detail
/// (docs/howto/publish.md, docs/formats.md). Waits for the surface to settle.
/// Fails: unimplemented (this program has no page), already_exists (the folder is not empty),
/// not_found naming the sessions that there are, failed_precondition (somebody edits the session),
/// resource_exhausted (the disk), as the server says, cancelled. Then nothing is left.
Result<Publication> publish(Connection& connection, const PublishWish& wish,
                            const Progress& progress);

}  // namespace burnish
