#pragma once

#include <memory>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include "client/cli/bench/gesture.h"
#include "client/connection/session_link.h"

namespace burnish {

struct LoadOptions {
  std::string session;
  std::shared_ptr<const View> view;
  uint64_t triangles_max = 0;
  double pictures_per_second = 60;
  LoadMix mix;
  /// A frame's age is told by the last heartbeat that it has seen: by so much it may be over-told.
  std::chrono::milliseconds heartbeat_interval{10};
};

/// What one client saw.
struct LoadFigures {
  double seconds = 0;
  uint64_t frames = 0;
  uint64_t bytes = 0;
  std::vector<double> age_ms;      ///< of frames when they came, one a picture at most
  std::vector<double> drawn_ms;    ///< the same when they were drawn
  std::vector<double> edit_ms;     ///< from an edit to its first frame
  std::vector<double> preview_ms;  ///< the same of previews
  uint64_t applied = 0;            ///< edits
  std::set<std::string> acknowledged;
  std::vector<std::string> refused;  ///< in words
  uint64_t times_lost = 0;           ///< the connection
  std::string ended;                 ///< why, where the session ended early
};

/// One person at a client: draws pictures, drags and paints, on a connection and a thread of its
/// own.
class LoadClient {
 public:
  /// Needs: `connection` lives as long as this does.
  LoadClient(const Connection& connection, const LoadOptions& options, uint32_t seed);

  void start(std::chrono::duration<double> length);
  /// Waits for the end of the gestures and for the answers to all edits.
  void join();

  /// Draws on until a settled frame has seen so many edits. False when patience is over.
  bool settle(uint64_t edits, std::chrono::seconds patience);

  const LoadFigures& figures() const { return figures_; }
  /// Of what is shown: equal for clients that show the same.
  uint64_t shown_hash() const;

 private:
  void run(std::chrono::duration<double> length);
  void draw();

  const LoadOptions options_;
  SessionLink session_;
  Gestures gestures_;
  LoadFigures figures_;
  LinkStats stats_;
  std::vector<int32_t> shown_;  // steps, tile by tile
  std::thread thread_;
};

}  // namespace burnish
