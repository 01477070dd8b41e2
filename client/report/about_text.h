#pragma once

#include <string>
#include <vector>

namespace burnish {

/// A paragraph of what the program says about itself.
struct AboutText {
  std::string title;  ///< "Version"
  std::string text;
};

/// Returns version, licence and the places of the documents, for the window and the page.
std::vector<AboutText> about_texts();

}  // namespace burnish
