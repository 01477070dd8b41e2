#include "server/config/config_file.h"

#include <algorithm>
#include <fstream>
#include <sstream>

#include <toml++/toml.h>

#include "common/base/nearest_word.h"
#include "server/config/config_keys.h"

namespace burnish {
namespace {

std::string place(const std::string& name, const toml::node& node) {
  return name + ":" + std::to_string(node.source().begin.line) + ": ";
}

/// Returns a value in the file's form; for lists and tables only their kind.
std::string text_of(const toml::node& node) {
  if (!node.is_value()) return node.is_table() ? "a table" : "a list";
  std::ostringstream text;
  node.visit([&](const auto& value) { text << value; });
  return text.str();
}

/// Returns a path of the file; the folder is the file's. A URL stays as it is.
std::filesystem::path path_from(const std::filesystem::path& folder, const std::string& text) {
  const bool is_url = text.find("://") != std::string::npos;
  return text.empty() || is_url ? std::filesystem::path(text) : folder / text;
}

/// Stores a node's value in the member of a configuration if it has the member's type.
struct Store {
  const toml::node& node;
  const std::filesystem::path& folder;  // of the file
  ServerConfig& config;

  bool operator()(int64_t ServerConfig::*member) const { return set<int64_t>(member); }
  bool operator()(bool ServerConfig::*member) const { return set<bool>(member); }
  bool operator()(std::string ServerConfig::*member) const { return set<std::string>(member); }
  bool operator()(std::filesystem::path ServerConfig::*member) const {
    const auto text = node.value_exact<std::string>();
    if (text) config.*member = path_from(folder, *text);
    return text.has_value();
  }
  bool operator()(BackendKind ServerConfig::*member) const {
    const auto kind = parse_backend(node.value_exact<std::string>().value_or(""));
    if (kind.is_ok()) config.*member = kind.value();
    return kind.is_ok();
  }
  bool operator()(std::vector<std::string> ServerConfig::*member) const {
    const toml::array* list = node.as_array();
    if (list == nullptr) return false;
    if (!list->empty() && !list->is_homogeneous(toml::node_type::string)) return false;
    (config.*member).clear();
    for (const toml::node& entry : *list) (config.*member).push_back(*entry.value<std::string>());
    return true;
  }

 private:
  template <typename Kind, typename Member>
  bool set(Member member) const {
    const auto value = node.value_exact<Kind>();
    if (value) config.*member = *value;
    return value.has_value();
  }
};

/// Says in words what a key's value must be.
std::string expected(const ConfigKey& key) {
  if (std::holds_alternative<int64_t ServerConfig::*>(key.member))
    return "an integer in " + std::to_string(key.min) + ".." + std::to_string(key.max);
  if (std::holds_alternative<bool ServerConfig::*>(key.member)) return "true or false";
  if (std::holds_alternative<BackendKind ServerConfig::*>(key.member))
    return "\"auto\", \"cpu\" or \"cuda\"";
  if (std::holds_alternative<std::vector<std::string> ServerConfig::*>(key.member))
    return "a list of strings";
  return "a string";
}

Status read_value(const ConfigKey& key, const toml::node& node, const std::filesystem::path& folder,
                  ServerConfig& config) {
  if (!std::visit(Store{node, folder, config}, key.member))
    return invalid_argument(key.name + " = " + text_of(node) + " is not " + expected(key));
  return check_limits(key, config);
}

bool is_table_of_keys(const std::string& name) {
  return std::ranges::any_of(config_keys(), [prefix = name + "."](const ConfigKey& key) {
    return key.name.starts_with(prefix);
  });
}

/// Returns what a file may name: keys, with their table's name before a dot, and tables.
std::vector<std::string> known_names() {
  std::vector<std::string> names;
  for (const ConfigKey& key : config_keys()) {
    names.push_back(key.name);
    if (const size_t dot = key.name.find('.'); dot != std::string::npos)
      names.push_back(key.name.substr(0, dot));
  }
  return names;
}

Status read_table(const toml::table& table, const std::string& prefix, const std::string& name,
                  ServerConfig& config) {
  const std::filesystem::path folder = std::filesystem::path(name).parent_path();
  for (const auto& [key, node] : table) {
    const std::string full = prefix + std::string(key.str());
    if (const ConfigKey* known = find_config_key(full)) {
      const Status status = read_value(*known, node, folder, config);
      if (!status.is_ok()) return invalid_argument(place(name, node) + status.message());
    } else if (node.is_table() && is_table_of_keys(full)) {
      RETURN_IF_ERROR(read_table(*node.as_table(), full + ".", name, config));
    } else {
      return invalid_argument(place(name, node) + "unknown key '" + full + "'" +
                              did_you_mean(full, known_names()));
    }
  }
  return Status::ok();
}

}  // namespace

Status read_config_text(std::string_view text, const std::string& name, ServerConfig& config) try {
  return read_table(toml::parse(text), "", name, config);
} catch (const toml::parse_error& error) {
  return invalid_argument(name + ":" + std::to_string(error.source().begin.line) + ": " +
                          std::string(error.description()));
}

Status read_config_file(const std::filesystem::path& path, ServerConfig& config) {
  std::ifstream file(path);
  if (!file) return not_found("cannot read the configuration " + path.string());
  std::ostringstream text;
  text << file.rdbuf();
  return read_config_text(text.str(), path.string(), config);
}

}  // namespace burnish
