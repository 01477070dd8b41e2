#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "client/model/workspace/workspace.h"
#include "client/script/script.h"

namespace burnish {

/// Does for a runner what differs from place to place.
struct ScriptHost {
  /// Returns when the workspace has called its wake(), or after the time.
  std::function<void(std::chrono::milliseconds)> wait;
  /// Keeps the picture of `screenshot` as PNG.
  std::function<Status(const Image&, const std::filesystem::path&)> keep_picture;
  std::chrono::milliseconds patience{600'000};  ///< limit for one command
  std::chrono::milliseconds saving{10'000};     ///< limit for edits to be saved
  /// Tells a warning of the log that is new; null: nobody hears it.
  std::function<void(const std::string&)> warn = nullptr;
};

/// Runs a script with a Workspace that is connected, as a user would.
class ScriptRunner {
 public:
  /// Needs: both outlive this.
  ScriptRunner(Workspace& workspace, PageRenderer& renderer, ScriptHost host);

  /// Stops at the first command that fails. Fails: as the command does, with its line;
  /// deadline_exceeded; failed_precondition if edits could not be saved before a session was left.
  Status run(const std::vector<ScriptLine>& script, const std::string& name);

  /// Updates until done() is true. Fails: deadline_exceeded; with the log's message of a failure.
  Status update_until(const std::function<bool()>& done, const std::string& what) {
    return update_until(done, what, host_.patience);
  }

 private:
  Status save_edits();
  Status run_line(const ScriptLine& line);
  Status run_session(const ScriptLine& line);
  Status run_view(const ScriptLine& line);
  Status run_size(const ScriptLine& line);
  Status run_pointer(const ScriptLine& line);
  Status run_export(const ScriptLine& line);
  Status run_fork(const ScriptLine& line);
  Status finish_picture();
  Status take_screenshot(const std::filesystem::path& path);

  Status update_until(const std::function<bool()>& done, const std::string& what,
                      std::chrono::milliseconds patience);
  /// Likewise, for the open session. Fails: failed_precondition if somebody closes it.
  Status update_document_until(const std::function<bool(const Document&)>& done,
                               const std::string& what);
  Status wait_for_noise();
  Status update();

  Workspace& workspace_;
  PageRenderer& renderer_;
  const ScriptHost host_;
  size_t messages_seen_ = workspace_.log.messages().size();
  bool is_camera_placed_ = false;  // by its distance: a new size of the picture keeps it
  bool has_scale_bar_ = false;     // pictures of the script, whatever the user's view has
};

}  // namespace burnish
