#include "server/s3/s3_credentials.h"

#include <cstdlib>
#include <fstream>
#include <map>

#include "server/trust/file_mode.h"

namespace burnish {
namespace {

std::string trimmed(const std::string& text) {
  const size_t begin = text.find_first_not_of(" \t\r");
  if (begin == std::string::npos) return {};
  return text.substr(begin, text.find_last_not_of(" \t\r") + 1 - begin);
}

/// Returns the values of the section [default], and of lines before any section.
std::map<std::string, std::string> read_lines(std::ifstream& file) {
  std::map<std::string, std::string> values;
  bool is_ours = true;
  for (std::string line; std::getline(file, line);) {
    line = trimmed(line);
    if (line.starts_with('[')) is_ours = line == "[default]";
    const size_t equals = line.find('=');
    if (!is_ours || line.starts_with('#') || line.starts_with(';') || equals == line.npos) continue;
    values[trimmed(line.substr(0, equals))] = trimmed(line.substr(equals + 1));
  }
  return values;
}

std::string environment(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? "" : value;
}

}  // namespace

Result<S3Credentials> read_s3_credentials(const std::filesystem::path& path) {
  RETURN_IF_ERROR(refuse_mode(path, S_IROTH, "read"));
  std::ifstream file(path);
  if (!file) return not_found("cannot read library.s3_credentials = '" + path.string() + "'");
  auto values = read_lines(file);
  for (const char* key : {"aws_access_key_id", "aws_secret_access_key"})
    if (values[key].empty())
      return invalid_argument("library.s3_credentials = '" + path.string() + "' has no line '" +
                              key + " = ...' in its section [default]");
  return S3Credentials{values["aws_access_key_id"], values["aws_secret_access_key"],
                       values["aws_session_token"]};
}

Result<S3Credentials> s3_credentials_of_environment() {
  S3Credentials credentials{environment("AWS_ACCESS_KEY_ID"), environment("AWS_SECRET_ACCESS_KEY"),
                            environment("AWS_SESSION_TOKEN")};
  if (!credentials.id.empty() && !credentials.secret.empty()) return credentials;
  return not_found(
      "there are no credentials: set library.s3_credentials, or AWS_ACCESS_KEY_ID and "
      "AWS_SECRET_ACCESS_KEY in the server's environment");
}

}  // namespace burnish
