#include <fstream>
#include <set>
#include <sstream>

#include <toml++/toml.h>

#include "server/trust/file_mode.h"
#include "server/trust/users.h"

namespace burnish {
namespace {

std::string place(const std::string& file, const toml::node& node) {
  return file + ":" + std::to_string(node.source().begin.line);
}

Result<std::string> read_text(const toml::node& node) {
  const auto text = node.value_exact<std::string>();
  if (!text) return invalid_argument("is not a string");
  if (text->empty() || text->size() > 200)
    return invalid_argument("has " + std::to_string(text->size()) + " bytes, outside 1..200");
  return *text;
}

int digit_value(char digit) {
  if (digit >= '0' && digit <= '9') return digit - '0';
  if (digit >= 'a' && digit <= 'f') return digit - 'a' + 10;
  return -1;
}

Result<TokenHash> parse_hash(const std::string& text) {
  TokenHash hash;
  bool right = text.size() == 2 * hash.size();
  for (size_t i = 0; right && i < hash.size(); ++i) {
    const int high = digit_value(text[2 * i]), low = digit_value(text[2 * i + 1]);
    right = high >= 0 && low >= 0;
    hash[i] = static_cast<unsigned char>(16 * high + low);
  }
  if (!right) return invalid_argument("is not 64 lower-case hexadecimal digits");
  return hash;
}

Status read_key(const std::string& key, const toml::node& node, User& user) {
  ASSIGN_OR_RETURN(const std::string text, read_text(node));
  if (key == "name") {
    user.name = text;
  } else if (key == "role") {
    ASSIGN_OR_RETURN(user.role, parse_role(text));
  } else if (key == "token_sha256") {
    ASSIGN_OR_RETURN(user.token_hash, parse_hash(text));
  } else if (key == "certificate") {
    user.certificate = text;
  } else {
    return invalid_argument("unknown key; use name, role, token_sha256 or certificate");
  }
  return Status::ok();
}

Result<User> read_user(const toml::table& table, const std::string& file) {
  User user;
  for (const auto& [key, node] : table)
    RETURN_IF_ERROR(read_key(std::string(key.str()), node, user)
                        .with_context(place(file, node) + ": " + std::string(key.str())));
  if (user.name.empty()) return invalid_argument(place(file, table) + ": the user has no name");
  if (!table.contains("role"))
    return invalid_argument(place(file, table) + ": user " + user.name + " has no role");
  if (!user.token_hash && user.certificate.empty())
    return invalid_argument(place(file, table) + ": user " + user.name +
                            " has neither token_sha256 nor certificate");
  return user;
}

/// Two users must not share a name, token or certificate.
Status check_unique(const std::vector<User>& users, const std::string& file) {
  std::set<std::string> names, certificates;
  std::set<TokenHash> tokens;
  for (const User& user : users) {
    const bool fresh = names.insert(user.name).second &&
                       (!user.token_hash || tokens.insert(*user.token_hash).second) &&
                       (user.certificate.empty() || certificates.insert(user.certificate).second);
    if (!fresh)
      return invalid_argument(file + ": user " + user.name +
                              " has the name, token or certificate of another user");
  }
  return Status::ok();
}

Result<UserTable> read_users(const toml::table& root, const std::string& file) {
  std::vector<User> users;
  for (const auto& [key, node] : root) {
    const toml::array* list = node.as_array();
    if (key.str() != "user" || list == nullptr || !list->is_array_of_tables())
      return invalid_argument(place(file, node) + ": '" + std::string(key.str()) +
                              "' is not a [[user]]");
    for (const toml::node& entry : *list) {
      ASSIGN_OR_RETURN(User user, read_user(*entry.as_table(), file));
      users.push_back(std::move(user));
    }
  }
  RETURN_IF_ERROR(check_unique(users, file));
  return UserTable(std::move(users));
}

}  // namespace

Result<UserTable> read_users_file(const std::filesystem::path& path) try {
  RETURN_IF_ERROR(refuse_mode(path, S_IWOTH, "written"));
  std::ifstream file(path);
  if (!file) return errno_status("cannot read the users in " + path.string(), errno);
  std::ostringstream text;
  text << file.rdbuf();
  return read_users(toml::parse(text.str()), path.string());
} catch (const toml::parse_error& error) {
  return invalid_argument(path.string() + ":" + std::to_string(error.source().begin.line) + ": " +
                          std::string(error.description()));
}

}  // namespace burnish
