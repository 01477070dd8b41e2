#pragma once

#include <atomic>
#include <map>
#include <memory>
#include <random>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include "burnish/v1/editing.grpc.pb.h"
#include "common/base/types.h"

namespace burnish {

/// Opens sessions without a pause. Two clients at once open the same new session, and the first
/// gives up at a random moment. Others ask for names that are ids; one edits by Apply, and forks
/// its session. Records what the server has acknowledged.
class RestlessOpeners {
 public:
  /// Opens the session of the Apply loop. Shapes: `cell` is active, grid units.
  RestlessOpeners(std::string address, std::string scan, const Vec3i& cell, uint32_t seed);
  ~RestlessOpeners() { stop(); }

  /// Opens and edits in its own thread until stop(), even if the server dies.
  void start();
  void stop();

  /// Returns in words the acknowledged facts that the server has lost. Needs: stopped, a running
  /// server.
  std::vector<std::string> broken_promises() const;

  /// Returns the number of sessions that two clients opened at once and of which one client was
  /// told.
  size_t told() const { return told_.size(); }
  size_t acknowledged() const;
  size_t forks() const { return forked_.size(); }

 private:
  using Stub = v1::Editing::Stub;
  void run(Stub& stub);
  void race(Stub& stub);
  void join(Stub& stub, const std::string& session);
  void forge(Stub& stub);
  void fork(Stub& stub);
  bool apply(Stub& stub, const std::string& session, const std::string& edit_id);

  const std::string address_, scan_;
  const Vec3i cell_;
  std::mt19937 random_;
  std::thread thread_;
  std::atomic<bool> stopping_{false};

  int races_ = 0, edits_ = 0, forks_ = 0;
  std::set<std::string> told_, forked_;                           // sessions
  std::map<std::string, std::vector<std::string>> acknowledged_;  // edits by session
  std::vector<std::string> wrongly_opened_;
};

}  // namespace burnish
