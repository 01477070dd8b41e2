#include "server/config/config.h"

#include <fstream>
#include <set>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "server/config/command_line.h"
#include "server/config/config_file.h"
#include "server/config/config_keys.h"
#include "server/config/config_reference.h"
#include "tests/common/temporary_folder.h"

namespace burnish {
namespace {

using testing::HasSubstr;

std::string refusal(const std::string& text) {
  ServerConfig config;
  const Status status = read_config_text(text, "server.toml", config);
  return status.is_ok() ? "accepted" : status.message();
}

template <typename... Words>
std::optional<CommandLine> parse(int& exit_code, const Words&... words) {
  const char* argv[] = {"burnish-server", words...};
  return parse_command_line(static_cast<int>(std::size(argv)), argv, exit_code);
}

TEST(ConfigFile, EveryKeyIsRead) {
  ServerConfig config;
  ASSERT_TRUE(read_config_text(R"(
      listen = "127.0.0.1:1"
      data = "/tmp/x"
      threads = 3
      workers = 5
      backend = "cpu"
      log_level = "debug"
      insecure = true
      idle_exit_seconds = 60
      socket_user_only = true
      [limits]
      sessions_max = 7
      kept_sessions_per_user = 5
      sessions_for_owners = 2
      history_bytes_per_session = 70000
      history_bytes_per_user = 80000
      upload_bytes_max = 1000
      memory_bytes_max = 2000
      [tls]
      certificate = "c.pem"
      client_certificate_required = false
      [web]
      listen = "127.0.0.1:2"
      hosts = ["burnish.lab", "b"]
      )",
                               "server.toml", config)
                  .is_ok());
  EXPECT_EQ(config.listen, "127.0.0.1:1");
  EXPECT_EQ(config.web_listen, "127.0.0.1:2");
  EXPECT_EQ(config.web_hosts, (std::vector<std::string>{"burnish.lab", "b"}));
  EXPECT_EQ(config.data, "/tmp/x");
  EXPECT_EQ(config.threads, 3);
  EXPECT_EQ(config.workers, 5);
  EXPECT_EQ(config.backend, BackendKind::kCpu);
  EXPECT_EQ(config.log_level, "debug");
  EXPECT_TRUE(config.insecure);
  EXPECT_EQ(config.idle_exit_seconds, 60);
  EXPECT_TRUE(config.socket_user_only);
  EXPECT_EQ(config.sessions_max, 7);
  EXPECT_EQ(config.kept_sessions_per_user, 5);
  EXPECT_EQ(config.sessions_for_owners, 2);
  EXPECT_EQ(config.history_bytes_per_session, 70'000);
  EXPECT_EQ(config.history_bytes_per_user, 80'000);
  EXPECT_EQ(config.upload_bytes_max, 1000);
  EXPECT_EQ(config.tls_certificate, "c.pem");
  EXPECT_FALSE(config.tls_client_certificate_required);
  EXPECT_EQ(resolved_memory_bytes_max(config), 2000u);
}

TEST(ConfigFile, AWrongKeyIsRefusedByNameAndLine) {
  EXPECT_THAT(refusal("threads = 1\nthreds = 4\n"),
              HasSubstr("server.toml:2: unknown key 'threds'; did you mean 'threads'?"));
  EXPECT_THAT(refusal("[limits]\nsession_max = 4\n"), HasSubstr("'limits.session_max'"));
  EXPECT_THAT(refusal("[tsl]\nkey = 4\n"),
              HasSubstr("server.toml:1: unknown key 'tsl'; did you mean 'tls'?"));
}

TEST(ConfigFile, AValueOfTheWrongKindIsRefused) {
  EXPECT_EQ(refusal("listen = 7\n"), "server.toml:1: listen = 7 is not a string");
  EXPECT_EQ(refusal("\nthreads = \"4\"\n"),
            "server.toml:2: threads = '4' is not an integer in 0..1024");
  EXPECT_THAT(refusal("limits = 3\n"), HasSubstr("'limits'"));
  EXPECT_THAT(refusal("data = [1]\n"), HasSubstr("data = a list is not a string"));
  EXPECT_THAT(refusal("web.hosts = \"b\"\n"),
              HasSubstr("web.hosts = 'b' is not a list of strings"));
  EXPECT_THAT(refusal("web.hosts = [1]\n"), HasSubstr("is not a list of strings"));
  EXPECT_EQ(refusal("web.hosts = []\n"), "accepted");
  EXPECT_THAT(refusal("backend = \"gpu\"\n"), HasSubstr("\"auto\", \"cpu\" or \"cuda\""));
}

TEST(ConfigFile, AValueOutsideItsLimitsIsRefusedWithFileKeyValueAndLimits) {
  EXPECT_EQ(refusal("\n[limits]\nsessions_max = 0\n"),
            "server.toml:3: limits.sessions_max = 0 is outside 1..1000000");
  EXPECT_EQ(refusal("log_format = \"xml\"\n"),
            "server.toml:1: log_format = 'xml' is not one of text, json");
}

TEST(ConfigFile, AJournalThatIsNotADatabaseIsRefusedAndNotRepeated) {
  ServerConfig config;
  config.journal = "mysql://ann:secret@db/burnish";
  const Status status = validate(config);
  EXPECT_EQ(status.code(), StatusCode::kInvalidArgument);
  EXPECT_THAT(status.message(), HasSubstr("postgresql://"));
  EXPECT_THAT(status.message(), testing::Not(HasSubstr("secret")));
  config.journal = "postgresql://burnish@db/burnish";
  EXPECT_TRUE(validate(config).is_ok());
}

/// Returns every key of a table, with its dots.
std::set<std::string> keys_in(std::istream& file) {
  std::set<std::string> keys;
  std::string table, line;
  while (std::getline(file, line)) {
    if (line.starts_with('[')) table = line.substr(1, line.find(']') - 1) + ".";
    const size_t equals = line.find(" = ");
    if (!line.starts_with('#') && equals != std::string::npos)
      keys.insert(table + line.substr(0, equals));
  }
  return keys;
}

TEST(ConfigFile, PathsAreRelativeToItsFolder) {
  ServerConfig config;
  ASSERT_TRUE(read_config_text(R"(
      data = "data"
      users = "/etc/users.toml"
      [tls]
      certificate = "tls/server.pem"
      [library]
      shared = "s3://bucket/scans"
      )",
                               "/etc/burnish/server.toml", config)
                  .is_ok());
  EXPECT_EQ(config.data, "/etc/burnish/data");
  EXPECT_EQ(config.users, "/etc/users.toml");
  EXPECT_EQ(config.tls_certificate, "/etc/burnish/tls/server.pem");
  EXPECT_EQ(config.library_shared, "s3://bucket/scans");
  EXPECT_TRUE(config.tls_key.empty());
}

TEST(ConfigExample, IsAcceptedAndHasEveryKeyWithItsDefault) {
  const std::string path = SOURCE_ROOT "/deploy/server.example.toml";
  ServerConfig config;
  const Status status = read_config_file(path, config);
  ASSERT_TRUE(status.is_ok()) << status.message();
  EXPECT_TRUE(validate(config).is_ok());
  config.data = config.data.lexically_relative(SOURCE_ROOT "/deploy");
  std::set<std::string> known;
  std::ifstream file(path);
  const ServerConfig defaults;
  for (const ConfigKey& key : config_keys()) {
    known.insert(key.name);
    std::visit([&](auto member) { EXPECT_EQ(config.*member, defaults.*member) << key.name; },
               key.member);
  }
  EXPECT_EQ(keys_in(file), known);
}

TEST(ConfigExample, IsAPartOfTheProgram) {
  ServerConfig config;
  ASSERT_TRUE(read_config_text(config_example(), "example", config).is_ok());
  std::istringstream example(config_example());
  EXPECT_EQ(keys_in(example).size(), config_keys().size());
}

TEST(ConfigKeys, AreDescribedWithTypeDefaultAndLimits) {
  const std::string json = config_keys_json();
  EXPECT_THAT(json, HasSubstr(R"("name": "threads",
  "type": "integer",
  "default": 0,
  "min": 0,
  "max": 1024)"));
  EXPECT_THAT(json, HasSubstr(R"("name": "web.hosts",
  "type": "list of strings",
  "default": [])"));
  for (const ConfigKey& key : config_keys())
    EXPECT_THAT(json, HasSubstr("\"" + key.name + "\"")) << key.name;
}

TEST(ConfigFile, BrokenTomlIsRefusedWithItsLine) {
  EXPECT_THAT(refusal("threads = 1\nlisten = \"x\n"), HasSubstr("server.toml:2"));
}

TEST(Config, ValuesOutsideTheirLimitsAreRefused) {
  ServerConfig config;
  EXPECT_TRUE(validate(config).is_ok());
  config.sessions_max = 0;
  EXPECT_THAT(validate(config).message(), HasSubstr("limits.sessions_max = 0"));
  config = {};
  config.listen = "localhost";
  EXPECT_THAT(validate(config).message(), HasSubstr("HOST:PORT"));
  config.listen = "localhost:99999";
  EXPECT_THAT(validate(config).message(), HasSubstr("0..65535"));
  config = {};
  config.log_level = "loud";
  EXPECT_THAT(validate(config).message(), HasSubstr("'loud'"));
}

TEST(Config, TheWebGatewayIsHeldToTheSameExposure) {
  ServerConfig config;
  config.web_listen = "0.0.0.0:7443";
  EXPECT_THAT(validate(config).message(), HasSubstr("web.listen = '0.0.0.0:7443' is reachable"));
  config.tls_certificate = config.tls_key = "x.pem";
  EXPECT_THAT(validate(config).message(), HasSubstr("without authentication"));
  config.users = "users.toml";
  EXPECT_TRUE(validate(config).is_ok());
  config.web_listen = "7443";
  EXPECT_THAT(validate(config).message(), HasSubstr("HOST:PORT"));
}

TEST(Config, PlaintextBeyondThisMachineNeedsSayingSo) {
  ServerConfig config;
  config.listen = "0.0.0.0:7411";
  EXPECT_EQ(validate(config).code(), StatusCode::kFailedPrecondition);
  EXPECT_THAT(validate(config).message(), HasSubstr("in plain text"));
  config.insecure = true;
  EXPECT_TRUE(validate(config).is_ok());
  config.insecure = false;
  config.tls_certificate = config.tls_key = "x.pem";
  EXPECT_THAT(validate(config).message(), HasSubstr("without authentication"));
  config.users = "users.toml";
  EXPECT_TRUE(validate(config).is_ok());
  for (const char* loopback : {"127.0.0.1:1", "[::1]:1", "localhost:1", "127.3.4.5:1"})
    EXPECT_TRUE(is_loopback(loopback)) << loopback;
  for (const char* other : {"0.0.0.0:1", "[::]:1", "10.0.0.1:1", "example.org:1", "127.evil.com:1",
                            "127.0.0.1.evil.com:1", "127.1:1", "localhost.evil.com:1"})
    EXPECT_FALSE(is_loopback(other)) << other;
}

TEST(Config, MetricsBeyondThisMachineNeedSayingSo) {
  ServerConfig config;
  config.metrics_listen = "127.0.0.1:9464";
  EXPECT_TRUE(validate(config).is_ok());
  config.metrics_listen = "0.0.0.0:9464";
  EXPECT_EQ(validate(config).code(), StatusCode::kFailedPrecondition);
  EXPECT_THAT(validate(config).message(), HasSubstr("metrics.listen = '0.0.0.0:9464'"));
  config.insecure = true;
  EXPECT_TRUE(validate(config).is_ok());
}

TEST(Config, KeysThatDoNotFitEachOtherAreRefused) {
  ServerConfig config;
  config.tls_certificate = "c.pem";
  EXPECT_THAT(validate(config).message(), HasSubstr("tls.key = '': give both or neither"));
  config.tls_key = "k.pem";
  config.tls_client_ca = "ca.pem";
  EXPECT_THAT(validate(config).message(), HasSubstr("tls.client_ca = 'ca.pem' needs users"));
  config = {};
  config.listen = "";
  EXPECT_THAT(validate(config).message(), HasSubstr("nobody could connect"));
  config.socket = "/run/burnish.sock";
  EXPECT_TRUE(validate(config).is_ok());
  config.journal = "postgresql://burnish@db/burnish";
  config.library_shared = "/lab";
  EXPECT_THAT(validate(config).message(), HasSubstr("library.shared = '/lab' needs fleet.name"));
  config.fleet_name = "one";
  EXPECT_TRUE(validate(config).is_ok());
  for (const char* name : {"a/b", "..", "one two", "\xc3\xa4"}) {
    config.fleet_name = name;
    EXPECT_THAT(validate(config).message(), HasSubstr("fleet.name = '" + std::string(name)));
  }
  config.fleet_name = "one";
  config.socket = std::string(200, 'x');
  EXPECT_THAT(validate(config).message(), HasSubstr("200 bytes"));
}

TEST(Config, KeysOfABucketNeedOne) {
  ServerConfig config;
  config.journal = "postgresql://burnish@db/burnish";
  config.fleet_name = "one";
  config.library_shared = "/lab";
  config.s3_credentials = "s3.ini";
  EXPECT_THAT(validate(config).message(), HasSubstr("library.s3_credentials is set"));
  EXPECT_THAT(validate(config).message(), HasSubstr("library.shared = '/lab' is not a bucket"));
  config.library_shared = "s3://scans/lab";
  EXPECT_TRUE(validate(config).is_ok());
  config.s3_addressing = "host";
  EXPECT_THAT(validate(config).message(), HasSubstr("'host' is not one of auto, path, virtual"));
}

TEST(Config, ScansCrossTheNetworkInPlainTextOnlyIfSomebodySaysSo) {
  ServerConfig config;
  config.journal = "postgresql://burnish@db/burnish";
  config.fleet_name = "one";
  config.library_shared = "s3://scans";
  for (const char* endpoint : {"https://s3.lab", "http://127.0.0.1:9000", "http://localhost",
                               "http://[::1]:9000", "http://[::1]"}) {
    config.s3_endpoint = endpoint;
    EXPECT_TRUE(validate(config).is_ok()) << endpoint;
  }
  for (const char* endpoint : {"http://s3.lab:9000", "http://10.0.0.1", "http://localhost.lab"}) {
    config.s3_endpoint = endpoint;
    EXPECT_EQ(validate(config).code(), StatusCode::kFailedPrecondition);
    EXPECT_THAT(validate(config).message(),
                HasSubstr("library.s3_endpoint = '" + std::string(endpoint)));
  }
  config.s3_endpoint = "http://me:hidden@s3.lab";
  EXPECT_THAT(validate(config).message(), testing::Not(HasSubstr("hidden")));
  config.s3_endpoint = "http://s3.lab:9000";
  config.insecure = true;
  EXPECT_TRUE(validate(config).is_ok());
}

TEST(CommandLine, FlagsGoBeforeTheFileAndTheFileBeforeTheDefaults) {
  const TemporaryFolder folder;
  const std::string file = folder.write("s.toml", "threads = 3\nlog_level = \"warn\"\n").string();
  int exit_code = -1;
  const auto line = parse(exit_code, "--config", file.c_str(), "--threads", "2");
  ASSERT_TRUE(line.has_value());
  EXPECT_EQ(line->config.threads, 2);
  EXPECT_EQ(line->config.log_level, "warn");
  EXPECT_EQ(line->config.workers, ServerConfig().workers);
}

TEST(CommandLine, AServerForOneUserListensOnItsSocketAlone) {
  int exit_code = 0;
  const auto line = parse(exit_code, "--listen", "", "--socket", "/tmp/s", "--socket-user-only",
                          "--idle-exit", "60");
  ASSERT_TRUE(line);
  EXPECT_EQ(line->config.listen, "");
  EXPECT_TRUE(line->config.socket_user_only);
  EXPECT_EQ(line->config.idle_exit_seconds, 60);
  EXPECT_FALSE(parse(exit_code, "--idle-exit", "-1"));
  EXPECT_EQ(exit_code, 2);
}

TEST(CommandLine, HelpEndsWith0AndNonsenseWith2) {
  int exit_code = -1;
  EXPECT_FALSE(parse(exit_code, "--help"));
  EXPECT_EQ(exit_code, 0);
  EXPECT_FALSE(parse(exit_code, "--nonsense"));
  EXPECT_EQ(exit_code, 2);
  EXPECT_FALSE(parse(exit_code, "--listen", "0.0.0.0:1"));
  EXPECT_EQ(exit_code, 2);
}

}  // namespace
}  // namespace burnish
