#pragma once

#include <deque>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "server/manager/session_manager.h"
#include "tests/common/temporary_folder.h"
#include "tests/server/live/serial_replay.h"
#include "tests/server/manager/test_library.h"

namespace burnish {

/// A history of several people at one session, drawn from a seed. They come and go, draw, undo,
/// switch, name states and fork. The network drops, repeats and reorders their messages. The server
/// gives memory back and is killed at any moment. The session's state is compared with SerialReplay
/// throughout.
class Simulator {
 public:
  /// Needs: a library with one scan; one simulator at a time.
  Simulator(TestLibrary& library, const ScanInfo& scan, uint64_t seed);

  /// Fails the running test if the session differs from the serial replay.
  void run();

  /// How often each event has happened. Tests check with it that the histories are rich.
  struct Counts {
    size_t edits = 0, refused = 0, known = 0, crashes = 0, lost = 0, forks = 0, spills = 0;
  };
  const Counts& counts() const { return counts_; }

 private:
  struct Message {
    size_t user;
    std::vector<Edit> edits;
  };
  struct User {
    std::string name;
    bool present = true;
    bool is_viewer = false;
    int last_id = 0;
    std::deque<std::vector<Edit>> unacknowledged;  // batches
  };

  void start_server(const std::filesystem::path& journal);
  void step();
  void draw_edits(size_t user);
  decltype(Edit::change) draw_change();
  void send(size_t user, const std::vector<Edit>& edits) { network_.push_back({user, edits}); }
  void reconnect(size_t user);
  void deliver();
  void receive(const Message& message);
  void acknowledge(size_t user, const std::vector<Edit>& edits);
  void crash();
  void adopt_what_survived();
  void fork();
  void change_role();
  void compare();

  /// Returns a number in 0..n-1.
  size_t pick(size_t n) { return std::uniform_int_distribution<size_t>(0, n - 1)(random_); }
  bool chance(double p) { return std::bernoulli_distribution(p)(random_); }

  TestLibrary& library_;
  const ScanInfo scan_;
  std::mt19937_64 random_;
  TemporaryFolder folder_;
  std::shared_ptr<const SharedMesh> mesh_;
  std::filesystem::path journal_path_;
  std::unique_ptr<Journal> journal_;
  std::unique_ptr<SessionManager> manager_;

  bool is_calm_ = false;  // less goes wrong, so that the history grows long
  std::string session_ = "first";
  std::vector<User> users_;
  std::vector<Message> network_;
  SerialReplay serial_;
  size_t acknowledged_ = 0;  // number of acknowledged serial edits
  Counts counts_;
};

}  // namespace burnish
