// The effect of a sticky CUDA error on a real server. All programs that the test runs lie beside
// it.

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <iostream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/mesh/io/mesh_io.h"
#include "server/solver/cuda/cuda_backend.h"
#include "tests/reference/compare.h"
#include "tests/system/server_process.h"
#include "tests/system/wire_call.h"

namespace burnish {
namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;

constexpr int kExitDeviceFailed = 3;  // server/main/main.cpp

enum class Health { kServing, kNotServing, kNone };

Health health_of(const std::shared_ptr<grpc::Channel>& channel) {
  const WireAnswer answer = call(channel, {"/grpc.health.v1.Health/Check", {""}});
  if (!answer.status.ok() || answer.messages.empty()) return Health::kNone;
  return answer.messages[0] == "\x08\x01" ? Health::kServing : Health::kNotServing;
}

class DeviceFault : public testing::Test {
 protected:
  void SetUp() override {
    if (const auto device = cuda_device(); !device.is_ok())
      GTEST_SKIP() << device.status().message();
    std::filesystem::current_path(std::filesystem::read_symlink("/proc/self/exe").parent_path());
    ::setenv("LD_PRELOAD", "./libfault_on_signal.so", 1);
    server_ = std::make_unique<ServerProcess>(std::vector<std::string>{"--backend", "cuda"});
    ::unsetenv("LD_PRELOAD");
  }

  void done(std::vector<std::string> words) {
    const CommandOutcome outcome = server_->burnish(std::move(words));
    ASSERT_EQ(outcome.exit_code, 0) << outcome.output;
  }

  std::vector<Vec3d> exported(const std::string& name) {
    const std::string path = (server_->folder / name).string();
    done({"export", "work", path, "--exact"});
    return read_mesh(path).value().vertices;
  }

  /// Returns the server's last answers about its health after SERVING.
  Health end_of_health() {
    const auto channel = wire_channel(server_->address);
    EXPECT_EQ(health_of(channel), Health::kServing);
    server_->arm_fault();
    const auto fault = Clock::now();
    Health health = Health::kServing;
    while (health == Health::kServing && Clock::now() < fault + kPatience)
      health = health_of(channel);
    const auto time = std::chrono::duration_cast<milliseconds>(Clock::now() - fault);
    std::cout << "the fault was told after " << time.count() << " ms\n";
    return health;
  }

  std::unique_ptr<ServerProcess> server_;
};

TEST_F(DeviceFault, IsToldEndsTheServerAndLosesNoEdit) {
  done({"import", write_sphere(server_->folder, 4), "--depth", "5", "--name", "ball"});
  done({"open", "ball", "--depth", "5", "--session", "work"});
  done({"edit", "work", "--alpha", "5", "--beta", "0"});
  const auto before = exported("before.ply");

  EXPECT_EQ(end_of_health(), Health::kNotServing);
  EXPECT_EQ(server_->process->wait(kPatience), kExitDeviceFailed);
  EXPECT_THAT(server_->process->output(), testing::HasSubstr("CUDA: "));

  server_->start();
  const double diagonal = 2 * std::sqrt(3);
  EXPECT_LE(reference::vertex_distance(before, exported("after.ply"), diagonal).max, 1e-6);
}

}  // namespace
}  // namespace burnish
