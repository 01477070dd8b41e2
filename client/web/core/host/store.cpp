#include "client/web/core/host/store.h"

#include "client/web/core/host/imports.h"

namespace burnish {

std::string stored_text(const std::string& key) {
  std::string text(host_store_get(key.data(), key.size()), '\0');
  host_store_take(text.data());
  return text;
}

void store_text(const std::string& key, const std::string& text) {
  host_store_set(key.data(), key.size(), text.data(), text.size());
}

}  // namespace burnish
