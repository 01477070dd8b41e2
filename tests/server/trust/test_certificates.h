#pragma once

#include <memory>
#include <string>

namespace burnish {

/// A CA of the test. Certificates are PEM text.
class TestCa {
 public:
  struct Issued {
    std::string certificate;
    std::string key;
  };

  explicit TestCa(const std::string& name);
  ~TestCa();

  const std::string& certificate() const { return own_.certificate; }

  /// Issues a certificate for 127.0.0.1 and localhost, for servers and clients, valid from
  /// yesterday until `days` from now; negative: expired.
  Issued issue(const std::string& common_name, int days = 30) const;

 private:
  struct Key;
  std::unique_ptr<Key> key_;
  Issued own_;
};

}  // namespace burnish
