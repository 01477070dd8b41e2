#include "server/config/config_reference.h"

#include <nlohmann/json.hpp>

#include "server/config/config_keys.h"

namespace burnish {
namespace {

using nlohmann::ordered_json;

/// Adds what a key's member says: its type, its default and its limits.
struct Describe {
  const ConfigKey& key;
  ordered_json& json;
  const ServerConfig defaults = {};

  void operator()(int64_t ServerConfig::*member) const {
    put("integer", defaults.*member);
    json["min"] = key.min;
    json["max"] = key.max;
  }
  void operator()(bool ServerConfig::*member) const { put("boolean", defaults.*member); }
  void operator()(std::string ServerConfig::*member) const {
    put("string", defaults.*member);
    if (!key.choices.empty()) json["choices"] = key.choices;
  }
  void operator()(std::filesystem::path ServerConfig::*member) const {
    put("path", (defaults.*member).string());
  }
  void operator()(BackendKind ServerConfig::*) const {
    put("string", "auto");
    json["choices"] = {"auto", "cpu", "cuda"};
  }
  void operator()(std::vector<std::string> ServerConfig::*member) const {
    put("list of strings", defaults.*member);
  }

 private:
  template <typename Value>
  void put(const char* type, const Value& value) const {
    json["type"] = type;
    json["default"] = value;
  }
};

}  // namespace

std::string config_keys_json() {
  ordered_json list = ordered_json::array();
  for (const ConfigKey& key : config_keys()) {
    ordered_json& json = list.emplace_back(ordered_json{{"name", key.name}});
    std::visit(Describe{key, json}, key.member);
  }
  return list.dump(1);
}

}  // namespace burnish
