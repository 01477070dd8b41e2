#pragma once

#include <memory>
#include <string>

namespace burnish {

/// A CA of the test's own. Certificates are PEM text.
class TestCa {
 public:
  struct Issued {
    std::string certificate;
    std::string key;
  };

  explicit TestCa(const std::string& name);
  ~TestCa();

  const std::string& certificate() const { return own_.certificate; }

  /// A certificate for 127.0.0.1 and localhost, of servers and clients alike, good from yesterday
  /// until `days` from now; negative: it has ended.
  Issued issue(const std::string& common_name, int days = 30) const;

 private:
  struct Key;
  std::unique_ptr<Key> key_;
  Issued own_;
};

}  // namespace burnish
