#pragma once

#include <string>

namespace burnish {

// Small texts that outlive the page: the browser keeps them for the page's origin.

/// Returns the text of a key; empty: there is none.
std::string stored_text(const std::string& key);
void store_text(const std::string& key, const std::string& text);

}  // namespace burnish
