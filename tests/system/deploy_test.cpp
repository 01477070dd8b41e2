// Uses the tools of deploy/ as the runbook says.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/system/server_process.h"

namespace burnish {
namespace {

using testing::HasSubstr;

constexpr char kDeploy[] = SOURCE_ROOT "/deploy/";

CommandOutcome run(const TemporaryFolder& folder, std::vector<std::string> words) {
  Process process(words, folder / "script.log");
  const int exit_code = process.wait(kPatience).value_or(-1);
  return {exit_code, process.output()};
}

/// Returns the lines after the first line that begins with `beginning`.
std::string after(const std::string& text, const std::string& beginning) {
  const size_t line = text.find("\n" + beginning);
  return text.substr(text.find('\n', line + 1) + 1);
}

TEST(LabScripts, MakeAServerAndAUserThatTrustEachOther) {
  const TemporaryFolder folder;
  const std::string tls = (folder / "tls").string();
  const CommandOutcome made =
      run(folder, {std::string(kDeploy) + "make-certificates", tls, "127.0.0.1,lab", "anna"});
  ASSERT_EQ(made.exit_code, 0) << made.output;
  const CommandOutcome token = run(folder, {std::string(kDeploy) + "make-token", "bert", "viewer"});
  ASSERT_EQ(token.exit_code, 0) << token.output;
  const std::string users = after(token.output, "entry for") +
                            "[[user]]\nname = \"anna\"\nrole = \"owner\"\ncertificate = \"anna\"\n";
  const std::string word = token.output.substr(token.output.find('\n') + 1, 64);

  ServerProcess server({"--tls-certificate", tls + "/server.pem", "--tls-key", tls + "/server.key",
                        "--tls-client-ca", tls + "/ca.pem", "--users",
                        folder.write("users.toml", users).string()});
  const std::vector<std::string> with_certificate = {"meshes",
                                                     "--tls-ca",
                                                     tls + "/ca.pem",
                                                     "--tls-certificate",
                                                     tls + "/client-anna.pem",
                                                     "--tls-key",
                                                     tls + "/client-anna.key"};
  const CommandOutcome anna = server.burnish(with_certificate);
  EXPECT_EQ(anna.exit_code, 0) << anna.output;
  std::vector<std::string> with_both = with_certificate;
  with_both.insert(with_both.end(), {"--token-file", folder.write("token", word).string()});
  const CommandOutcome bert = server.burnish(with_both);
  EXPECT_EQ(bert.exit_code, 0) << bert.output;
}

TEST(LabScripts, KeepWhatIsThereAndRefuseNonsense) {
  const TemporaryFolder folder;
  const std::string script = std::string(kDeploy) + "make-certificates";
  const std::string tls = (folder / "tls").string();
  ASSERT_EQ(run(folder, {script, tls, "lab"}).exit_code, 0);
  const std::string before = content_of(folder / "tls/server.pem");
  ASSERT_EQ(run(folder, {script, tls, "lab", "carl"}).exit_code, 0);
  EXPECT_EQ(content_of(folder / "tls/server.pem"), before);
  EXPECT_TRUE(std::filesystem::exists(folder / "tls/client-carl.pem"));
  EXPECT_EQ(run(folder, {script, tls, "lab", "no/name"}).exit_code, 1);
  EXPECT_EQ(run(folder, {script}).exit_code, 2);
  EXPECT_THAT(run(folder, {std::string(kDeploy) + "make-token", "x", "king"}).output,
              HasSubstr("'king' is not one of viewer, editor, owner"));
}

}  // namespace
}  // namespace burnish
