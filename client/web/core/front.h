#pragma once

#include <chrono>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "client/model/workspace/workspace.h"
#include "client/web/core/front_state.h"

namespace burnish {

/// A file that the user has given to the page.
struct GivenFile {
  int handle = 0;  ///< of the worker
  std::string name;
  uint64_t size_bytes = 0;
};

/// Does for the front what the page's worker can.
struct FrontHost {
  /// Says a message of client/web/page/src/protocol.ts as JSON.
  std::function<void(const std::string&)> say;
  /// Shows the picture that the renderer has drawn.
  std::function<void()> show;
  /// Returns whether the card still draws that picture.
  std::function<bool()> is_drawing;
  /// Says how smooth edges are from the next picture on, where processors draw. Empty with a card:
  /// they are always smooth.
  std::function<void(bool)> set_smooth;
  /// Returns how long processors drew the last picture; with set_smooth.
  std::function<double()> draw_ms;
  /// Makes a file known by its name, for Workspace::import_scan().
  std::function<void(const GivenFile&)> give;
  std::function<Result<std::string>(const GivenFile&)> read;
  /// Hands a file to the user.
  std::function<void(const std::string& name, std::string_view bytes)> download;
  /// Runs work that may wait, soon.
  std::function<void(std::function<void()>)> begin;
  /// Waits within such work until the next picture, or for the time.
  std::function<void(std::chrono::milliseconds)> wait;
};

/// The page's end of the model: takes its messages and lines, draws, and says snapshots. The window
/// and `burnish --script` are the model's other fronts. Used from one thread.
class Front {
 public:
  using Time = std::chrono::steady_clock::time_point;

  /// Needs: the renderer outlives this.
  Front(PageRenderer& renderer, Preferences preferences, WorkspaceOptions options, FrontHost host);

  /// Hears a message of the page as JSON. A message that is not understood is answered.
  void hear(std::string_view json);

  /// Handles all news, draws if the picture has changed, and says a snapshot if it has changed.
  /// Returns when to be called again at the latest; Time::max(): when the workspace wakes.
  Time tick(Time now);

  Workspace& workspace() { return workspace_; }

 private:
  /// Decides the picture.
  struct Shown {
    uint64_t begun = 0;
    bool is_raw = false;
    uint64_t changes = 0;
    ImageSize size;
    Camera camera;
    DrawStyle style;
    bool is_smooth = true;

    bool operator==(const Shown&) const = default;
  };

  void do_line(const std::string& line);
  void replay(const GivenFile& script);
  /// Returns whether the next picture may begin: one after the other, so that none waits in line.
  bool may_draw(Time now);
  Status draw(Time now);
  Status draw_surface(bool is_smooth);
  /// Returns what a picture is to show, as smooth as the last one is.
  Shown next_shown() const;
  /// Returns whether a picture is to have smooth edges. They cost time, so they are for rest.
  bool is_at_rest(const Shown& next, Time now) const;
  void keep_picture_now_and_then(Time now);
  /// Says the small picture of a strength, if one is waited for and the picture is at rest.
  void say_strength_picture();
  /// Returns when to try again; Time::max(): it was said, or has not changed.
  Time say_snapshot(Time now);
  /// Says what lies over the picture and follows the camera, if it has changed.
  void say_guides();
  void answer(const std::string& line, const Status& status);

  PageRenderer& renderer_;
  FrontHost host_;
  FrontState state_;
  Workspace workspace_;
  bool is_visible_ = true;
  Shown shown_;
  Time changed_at_{};  // when the picture was to show something else
  uint64_t pictures_ = 0;
  std::optional<Time> begun_at_;      // of the picture that the card draws
  std::optional<double> surface_ms_;  // how long processors drew it
  uint64_t kept_picture_ = 0;         // the last that was kept for the start page
  std::string kept_session_;
  Time kept_at_{};
  std::string said_;         // the last snapshot
  std::string said_guides_;  // likewise
  Time said_at_{};
  std::string failure_;  // of the last picture
};

}  // namespace burnish
