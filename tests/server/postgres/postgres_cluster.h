#pragma once

#include <filesystem>
#include <string>

namespace burnish {

/// A PostgreSQL server of a test's own, on a Unix socket in a temporary folder. It runs as the user
/// postgres if the test is root. It ends with the test program, however that ends.
class PostgresCluster {
 public:
  /// Settings are `name=value`, separated by spaces. Ends the program if PostgreSQL is not there.
  explicit PostgresCluster(const std::string& settings = {});
  /// Makes a standby that follows `primary`.
  explicit PostgresCluster(PostgresCluster& primary);
  PostgresCluster(const PostgresCluster&) = delete;
  PostgresCluster& operator=(const PostgresCluster&) = delete;

  /// Returns the cluster of this program.
  static PostgresCluster& shared();

  /// Makes an empty database, and returns its URI.
  std::string make_database();

  /// Returns the URI of a database.
  std::string uri(const std::string& database) const;

  void start();
  /// Sends SIGKILL to the server, and waits for its end.
  void kill();
  /// Turns a standby into a primary.
  void promote() const;
  /// Stops or continues all processes of the server.
  void signal_all(int number) const;

  const std::filesystem::path& folder() const { return folder_; }

 private:
  void make_folder();
  void watch() const;
  void as_owner(const std::string& command) const;
  int first_process() const;

  std::filesystem::path folder_;
  std::string settings_;
  int databases_ = 0;
};

}  // namespace burnish
