#pragma once

#include <chrono>
#include <functional>
#include <map>
#include <string>
#include <thread>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "client/scene/null_page_renderer.h"
#include "client/web/core/front.h"
#include "tests/system/server_process.h"

namespace burnish {

/// A page without a browser: a Front over the native model, with a session over a sphere.
class FrontService : public testing::Test {
 protected:
  using Json = nlohmann::json;
  using milliseconds = std::chrono::milliseconds;

  /// `preferences`: file in the server's folder; empty: nothing is kept.
  explicit FrontService(
      std::unique_ptr<PageRenderer> renderer = std::make_unique<NullPageRenderer>(),
      const std::string& preferences = "", const PageBudget& budget = {})
      : renderer_(std::move(renderer)), options_(options_with(preferences, budget)) {
    EXPECT_TRUE(owner_.import_scan(write_sphere(server_.folder, 4), "ball", {5, 0}, {}).is_ok());
    EXPECT_TRUE(owner_.open_session({"ball", "work", {5, 0}}).is_ok());
  }

  static void SetUpTestSuite() { ::setenv("OMP_WAIT_POLICY", "passive", 0); }

  WorkspaceOptions options_with(const std::string& preferences, const PageBudget& budget) const {
    WorkspaceOptions options;
    options.budget = budget;
    if (!preferences.empty()) options.preferences = server_.folder / preferences;
    return options;
  }

  FrontHost host() {
    FrontHost host;
    host.say = [this](const std::string& json) { take(Json::parse(json)); };
    host.show = [] {};
    host.is_drawing = [this] { return is_drawing_; };
    host.give = [](const GivenFile&) {};
    host.read = [this](const GivenFile& file) -> Result<std::string> { return given_[file.name]; };
    host.download = [this](const std::string& name, std::string_view bytes) {
      downloads_[name] = std::string(bytes);
    };
    host.begin = [this](std::function<void()> work) { work_ = std::move(work); };
    host.wait = [this](milliseconds time) {
      if (meanwhile_) meanwhile_();
      std::this_thread::sleep_for(time);
    };
    return host;
  }

  void take(const Json& message) {
    if (message["kind"] == "snapshot") snapshot_ = message["snapshot"];
    if (message["kind"] == "guides") guides_ = message;
    if (message["kind"] == "answer") answers_.push_back(message["message"]);
    if (message["kind"] == "drawn") drawn_ = message["count"];
    if (message["kind"] == "strength") strengths_[message["number"]] = message["address"];
  }

  void hear(const Json& message) { front_.hear(message.dump()); }
  void line(const std::string& text) { hear({{"kind", "command"}, {"line", text}}); }
  void point(const std::string& what, double x, double y) {
    hear({{"kind", "pointer"},
          {"what", what},
          {"x", x},
          {"y", y},
          {"button", 0},
          {"modifiers", 0},
          {"pressure", 1},
          {"pen", false},
          {"delta", 0}});
  }

  /// Ticks until the snapshot is as wished.
  bool until(const std::function<bool()>& done) {
    const auto deadline = std::chrono::steady_clock::now() + kPatience;
    while (std::chrono::steady_clock::now() < deadline) {
      front_.tick(std::chrono::steady_clock::now());
      if (work_) std::exchange(work_, {})();
      if (!snapshot_.is_null() && done()) return true;
      std::this_thread::sleep_for(milliseconds(2));  // the server has the clock
    }
    return false;
  }

  bool start() {
    hear({{"kind", "start"},
          {"width", 400},
          {"height", 300},
          {"pixelRatio", 1},
          {"address", "http://" + server_.address},
          {"user", "mia"},
          {"token", ""}});
    return until([this] { return !snapshot_["library"]["sessions"].empty(); });
  }

  bool open() {
    if (!start()) return false;
    line("session join " + snapshot_["library"]["sessions"][0]["id"].get<std::string>());
    return until(
        [this] { return is_settled() && front_.workspace().document()->is_picture_settled(); });
  }

  bool is_settled() { return !snapshot_["document"].is_null() && document()["settled"] == true; }
  const Json& document() { return snapshot_["document"]; }

  void replay(const std::string& script) {
    given_["one.script"] = script;
    hear({{"kind", "replay"},
          {"file", {{"handle", 1}, {"name", "one.script"}, {"size", script.size()}}}});
  }

  bool has_message(const std::string& part) {
    return snapshot_["messages"].dump().find(part) != std::string::npos;
  }

  ServerProcess server_;
  Connection owner_ = Connection::open(server_.address, kPatience).value();
  std::unique_ptr<PageRenderer> renderer_;
  Json snapshot_;
  Json guides_;  // the scale bar and the axes
  std::vector<std::string> answers_;
  int drawn_ = 0;
  bool is_drawing_ = false;
  std::map<std::string, std::string> given_;
  std::map<std::string, std::string> downloads_;
  std::map<uint64_t, std::string> strengths_;  // addresses of small pictures, by number
  std::function<void()> work_;
  std::function<void()> meanwhile_;  // what happens while a script waits
  WorkspaceOptions options_;
  Front front_{*renderer_, Preferences(), options_, host()};
};

}  // namespace burnish
