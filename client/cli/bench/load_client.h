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
  std::shared_ptr<const LoadSurface> surface;
  double pictures_per_second = 60;
  LoadMix mix;
  /// A frame's age is measured from the last heartbeat that it has seen, so it may be too large by
  /// this interval.
  std::chrono::milliseconds heartbeat_interval{10};
};

/// Figures of one client.
struct LoadFigures {
  double seconds = 0;
  uint64_t frames = 0;
  uint64_t bytes = 0;
  std::vector<double> age_ms;      ///< age of frames on arrival, at most one per picture
  std::vector<double> drawn_ms;    ///< age of frames when drawn
  std::vector<double> edit_ms;     ///< from an edit to its first frame
  std::vector<double> preview_ms;  ///< from a preview to its first frame
  uint64_t applied = 0;            ///< edits sent
  std::set<std::string> acknowledged;
  std::vector<std::string> refused;  ///< in words
  uint64_t times_lost = 0;           ///< how often the connection was lost
  std::string ended;                 ///< why, if the session ended early
};

/// Simulates one user: draws pictures, drags and paints on its own thread.
class LoadClient {
 public:
  /// Needs: `connection` outlives this object.
  LoadClient(const Connection& connection, const LoadOptions& options, uint32_t seed);

  void start(std::chrono::duration<double> length);
  /// Waits for the end of the gestures and for the answers to all edits.
  void join();

  /// Draws until a settled frame of all pages has seen `edits` edits. Returns false after
  /// `patience`.
  bool settle(uint64_t edits, std::chrono::seconds patience);

  const LoadFigures& figures() const { return figures_; }
  /// Returns a hash of the shown surface: equal for clients that show the same.
  uint64_t shown_hash() const;

 private:
  void run(std::chrono::duration<double> length);
  void draw();

  const LoadOptions options_;
  SessionLink session_;
  Gestures gestures_;
  LoadFigures figures_;
  LinkStats stats_;
  std::shared_ptr<const SurfaceFrame> shown_;
  std::thread thread_;
};

}  // namespace burnish
