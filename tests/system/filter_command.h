#pragma once

#include <chrono>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "common/base/check.h"
#include "common/generate/generate.h"
#include "common/mesh/io/mesh_io.h"
#include "tests/common/temporary_folder.h"
#include "tests/system/process.h"

namespace burnish {

inline constexpr std::chrono::minutes kFilterPatience{2};

/// `burnish filter` as users see it, in a folder of its own with a sphere in in().
class FilterCommand : public testing::Test {
 protected:
  FilterCommand() {
    const Status written = write_mesh(make_icosphere(4, 10), in());
    BURNISH_CHECK(written.is_ok(), written.message());
  }

  std::string in() const { return (folder_ / "in.ply").string(); }
  std::string out() const { return (folder_ / "out.ply").string(); }
  std::string path(const std::string& name) const { return (folder_ / name).string(); }

  /// Runs burnish with these arguments. Returns its exit code and keeps its output.
  int burnish(std::vector<std::string> arguments, const Process::Limits& limits = {}) {
    arguments.insert(arguments.begin(), BURNISH_BINARY);
    Process process(arguments, folder_ / "log", limits);
    const int code = process.wait(kFilterPatience).value_or(-1);
    output_ = process.output();
    return code;
  }

  nlohmann::json report() const {
    std::ifstream file(folder_ / "report.json");
    return nlohmann::json::parse(file);
  }

  TemporaryFolder folder_;
  std::string output_;
};

}  // namespace burnish
