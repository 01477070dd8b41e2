#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "server/web/web_files.h"

namespace burnish {

/// The part of a request for a file that its answer depends on.
struct PageRequest {
  std::string_view method;         ///< "GET"
  std::string_view target;         ///< "/assets/style-1f2e.css"
  std::string_view if_none_match;  ///< headers; empty for none
  std::string_view accept_encoding;
};

struct PageAnswer {
  unsigned status = 200;
  std::vector<std::pair<const char*, std::string>> headers;
  std::string_view body;  ///< of the files, or a literal
};

/// Answers with a file, with 304 where the browser has it, else 404 or 405. Needs: `files` outlives
/// the answer.
PageAnswer answer_page(const WebFiles& files, const PageRequest& request);

/// Answers `status` with its reason as plain text. Needs: `reason` outlives the answer.
PageAnswer refuse_page(unsigned status, std::string_view reason);

}  // namespace burnish
