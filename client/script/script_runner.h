#pragma once

#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>

#include "client/model/workspace.h"
#include "client/script/script.h"

namespace burnish {

struct ScriptOptions {
  std::string server;  ///< empty: the private server
  ImageSize size{1280, 960};
  std::chrono::milliseconds patience{600'000};  ///< limit for one command
  WorkspaceOptions workspace;
};

/// Runs a script with a Workspace, as the window would, but without a window.
class ScriptRunner {
 public:
  ScriptRunner(PageRenderer& renderer, ScriptOptions options);

  /// Stops at the first command that fails. Fails: as the command does, with its line;
  /// deadline_exceeded; failed_precondition if edits could not be saved before a session was left.
  Status run(const std::vector<ScriptLine>& script, const std::string& name);

  Workspace& workspace() { return *workspace_; }

 private:
  Status connect();
  Status save_edits();
  Status run_line(const ScriptLine& line);
  Status run_session(const ScriptLine& line);
  Status run_edit(const ScriptLine& line);
  Status run_view(const ScriptLine& line);
  Status run_pointer(const ScriptLine& line);
  Status run_export(const ScriptLine& line);
  Status finish_picture();
  Status take_screenshot(const std::filesystem::path& path);
  void print_state() const;

  /// Updates until done() is true. Fails: deadline_exceeded; with the log's message of a failure.
  Status update_until(const std::function<bool()>& done, const std::string& what) {
    return update_until(done, what, options_.patience);
  }
  Status update_until(const std::function<bool()>& done, const std::string& what,
                      std::chrono::milliseconds patience);
  Status update();

  PageRenderer& renderer_;
  ScriptOptions options_;
  std::mutex mutex_;
  std::condition_variable news_;
  bool has_news_ = false;
  size_t messages_seen_ = 0;
  bool is_camera_placed_ = false;         // by its distance: a new size of the picture keeps it
  std::unique_ptr<Workspace> workspace_;  // last member: its threads wake this object
};

}  // namespace burnish
