#pragma once

#include <map>
#include <span>
#include <string>
#include <string_view>

#include "common/base/carried_file.h"

namespace burnish {

/// A file of the page, in the forms that it goes out in.
struct WebFile {
  std::string type;           ///< of its content, "text/html; charset=utf-8"
  std::string bytes;          ///< as it is
  std::string gzipped;        ///< the same, packed
  std::string_view brotli;    ///< packed better, by the build; empty: not there
  std::string etag;           ///< a hash of the bytes, in quotes
  bool is_immutable = false;  ///< its name has a hash: it never changes
};

/// The files of the page by the target of a request: "/", "/favicon.ico", "/assets/style-1f2e.css".
/// A request's target is only ever looked up in this list.
class WebFiles {
 public:
  /// The page that the program carries.
  WebFiles();

  /// index.html becomes "/". NAME.br is a form of NAME. Each "asset" of the list gets a name with a
  /// hash, which takes the place of "assets/NAME" in index.html. Needs: an index.html and known
  /// endings of names.
  explicit WebFiles(std::span<const CarriedFile> files);

  /// Returns null if no file has this target. `target` may have a query, which counts for nothing.
  const WebFile* find(std::string_view target) const;

  const std::map<std::string, WebFile, std::less<>>& all() const { return files_; }

 private:
  std::map<std::string, WebFile, std::less<>> files_;
};

/// Returns the files of server/web/page.
std::span<const CarriedFile> carried_files();

}  // namespace burnish
