#pragma once

#include <string>

namespace burnish {

/// The address of a server in a fleet. Status::moved() carries its text.
struct ServerPlace {
  std::string address;  ///< HOST:PORT; empty: it is reached through a proxy alone
  std::string node;     ///< its name, by which a proxy finds it; never has '@'

  bool operator==(const ServerPlace&) const = default;

  /// Returns "NODE@ADDRESS".
  std::string text() const { return node + "@" + address; }
  static ServerPlace of(const std::string& text) {
    const size_t at = text.find('@');
    if (at == std::string::npos) return {text, {}};
    return {text.substr(at + 1), text.substr(0, at)};
  }
};

}  // namespace burnish
