#include "server/config/config_file.h"

#include <fstream>
#include <functional>
#include <map>
#include <sstream>

#include <toml++/toml.h>

namespace burnish {
namespace {

using Reader = std::function<Status(const toml::node&)>;

/// A reader that stores a value of exactly this kind.
template <typename Stored, typename Target>
Reader store(Target& target, const char* kind) {
  return [&target, kind](const toml::node& node) {
    const auto value = node.value_exact<Stored>();
    if (!value) return invalid_argument(std::string("is not ") + kind);
    target = static_cast<Target>(*value);
    return Status::ok();
  };
}

Reader store_count(int& target) {
  return [&target](const toml::node& node) {
    const auto value = node.value_exact<int64_t>();
    if (!value || *value < 0 || *value > 1'000'000)
      return invalid_argument("is not an integer in 0..1000000");
    target = static_cast<int>(*value);
    return Status::ok();
  };
}

Reader store_backend(BackendKind& target) {
  return [&target](const toml::node& node) {
    ASSIGN_OR_RETURN(target, parse_backend(node.value_exact<std::string>().value_or("")));
    return Status::ok();
  };
}

using Readers = std::map<std::string, Reader, std::less<>>;

std::string place(const std::string& name, const toml::node& node) {
  return name + ":" + std::to_string(node.source().begin.line);
}

Status read_table(const toml::table& table, const std::string& prefix, const Readers& readers,
                  const std::string& name) {
  for (const auto& [key, node] : table) {
    const std::string full = prefix + std::string(key.str());
    const auto reader = readers.find(full);
    if (reader != readers.end()) {
      RETURN_IF_ERROR(reader->second(node).with_context(place(name, node) + ": " + full));
    } else if (node.is_table() && full == "limits") {
      RETURN_IF_ERROR(read_table(*node.as_table(), full + ".", readers, name));
    } else {
      return invalid_argument(place(name, node) + ": there is no key '" + full + "'");
    }
  }
  return Status::ok();
}

}  // namespace

Status read_config_text(std::string_view text, const std::string& name, ServerConfig& config) try {
  const Readers readers = {
      {"listen", store<std::string>(config.listen, "a string")},
      {"data", store<std::string>(config.data, "a string")},
      {"threads", store_count(config.threads)},
      {"workers", store_count(config.workers)},
      {"backend", store_backend(config.backend)},
      {"log_level", store<std::string>(config.log_level, "a string")},
      {"insecure", store<bool>(config.insecure, "true or false")},
      {"limits.sessions_max", store<int64_t>(config.sessions_max, "an integer")},
      {"limits.upload_bytes_max", store<int64_t>(config.upload_bytes_max, "an integer")},
      {"limits.mesh_bytes_max", store<int64_t>(config.mesh_bytes_max, "an integer")},
  };
  return read_table(toml::parse(text), "", readers, name);
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
