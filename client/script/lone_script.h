#pragma once

#include <condition_variable>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "client/model/workspace/workspace.h"
#include "client/script/script_runner.h"

namespace burnish {

struct ScriptOptions {
  std::string server;  ///< empty: the private server
  ImageSize size{1280, 960};
  std::chrono::milliseconds patience{600'000};  ///< limit for one command
  WorkspaceOptions workspace;
};

/// Runs a script with a Workspace of its own, without a window.
class LoneScript {
 public:
  LoneScript(PageRenderer& renderer, ScriptOptions options);

  /// Connects first. Says warnings on standard error. Fails: as ScriptRunner::run().
  Status run(const std::vector<ScriptLine>& script, const std::string& name);

  Workspace& workspace() { return *workspace_; }

 private:
  void wait(std::chrono::milliseconds time);
  Status connect(ScriptRunner& runner);

  PageRenderer& renderer_;
  ScriptOptions options_;
  std::mutex mutex_;
  std::condition_variable news_;
  bool has_news_ = false;
  std::unique_ptr<Workspace> workspace_;  // last member: its threads wake this object
};

}  // namespace burnish
