#include "client/report/about_text.h"

namespace burnish {

std::vector<AboutText> about_texts() {
  return {{"Version", "Burnish " BURNISH_VERSION},
          {"Licence",
           "Copyright (c) 2026 The Burnish authors. MIT License: free to use, change and pass on, "
           "without warranty."},
          {"Manual",
           "docs/window.md and docs/web.md in the source, beside a tutorial and pages for tasks; "
           "README.md lists all of them. The Debian package has a manual page: man burnish."},
          {"Keys", "Help, Keys lists them; ? opens the list."}};
}

}  // namespace burnish
