#include "client/script/lone_script.h"

#include <iostream>

#include "client/scene/png_writer.h"

namespace burnish {

LoneScript::LoneScript(PageRenderer& renderer, ScriptOptions options)
    : renderer_(renderer), options_(std::move(options)) {
  options_.workspace.wake = [this] {
    const std::lock_guard lock(mutex_);
    has_news_ = true;
    news_.notify_one();
  };
  workspace_ = std::make_unique<Workspace>(renderer, Preferences(), options_.workspace);
  workspace_->viewport.set_size(options_.size);
}

Status LoneScript::run(const std::vector<ScriptLine>& script, const std::string& name) {
  ScriptRunner runner(
      *workspace_, renderer_,
      {.wait = [this](std::chrono::milliseconds time) { wait(time); },
       .keep_picture = [](const Image& image,
                          const std::filesystem::path& path) { return write_png(image, path); },
       .patience = options_.patience,
       .saving = options_.workspace.timeout,
       .warn = [](const std::string& text) { std::cerr << "warning: " << text << "\n"; }});
  RETURN_IF_ERROR(connect(runner));
  return runner.run(script, name);
}

void LoneScript::wait(std::chrono::milliseconds time) {
  std::unique_lock lock(mutex_);
  news_.wait_for(lock, time, [this] { return has_news_; });
  has_news_ = false;
}

Status LoneScript::connect(ScriptRunner& runner) {
  if (options_.server.empty()) {
    workspace_->connect_privately();
  } else {
    workspace_->connect(options_.server);
  }
  return runner.update_until(
      [this] { return workspace_->library().state == Library::State::kConnected; }, "connecting");
}

}  // namespace burnish
