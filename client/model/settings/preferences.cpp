#include "client/model/settings/preferences.h"

#include <algorithm>
#include <sstream>

#include <toml++/toml.h>

#include "client/model/files/private_folder.h"
#include "client/model/input/bindings.h"
#include "client/model/settings/lighting_toml.h"
#include "client/tools/user_folders.h"
#include "common/base/atomic_file.h"
#include "common/base/limits.h"

namespace burnish {

std::filesystem::path preferences_path() {
  const std::filesystem::path folder = config_folder();
  return folder.empty() ? folder : folder / "window.toml";
}

namespace {

template <typename T>
void read(const toml::table& table, const char* key, T& value) {
  value = table[key].value_or(value);
}

void read_numbers(const toml::table& table, Preferences& preferences) {
  read(table, "user", preferences.user);
  read(table, "brush_radius_part", preferences.brush_radius_part);
  read(table, "brush_strength", preferences.brush_strength);
  read(table, "brush_beta", preferences.brush_beta);
  read(table, "pen_pressure", preferences.pen_pressure);
  read(table, "light_theme", preferences.light_theme);
  read(table, "scale", preferences.scale);
  read(table, "window_width", preferences.window_width);
  read(table, "window_height", preferences.window_height);
  preferences.brush_radius_part = std::clamp(preferences.brush_radius_part, 1e-4, 0.5);
  preferences.brush_strength = std::clamp(preferences.brush_strength, 0.01, 1.0);
  preferences.brush_beta = std::clamp(preferences.brush_beta, kBetaMin, kBetaMax);
  preferences.scale = std::clamp(preferences.scale, 0.0, 4.0);
}

void read_recent(const toml::table& table, Preferences& preferences) {
  const toml::array* recent = table["recent"].as_array();
  if (!recent) return;
  for (const toml::node& node : *recent) {
    const toml::table* entry = node.as_table();
    if (!entry || preferences.recent.size() == kRecentMax) continue;
    RecentSession session;
    read(*entry, "server", session.server);
    read(*entry, "session", session.session);
    read(*entry, "scan", session.scan);
    read(*entry, "id", session.id);
    read(*entry, "scan_name", session.scan_name);
    read(*entry, "shown", session.shown_unix_seconds);
    session.size_bytes = static_cast<uint64_t>((*entry)["size_bytes"].value_or<int64_t>(0));
    preferences.recent.push_back(session);
  }
}

// Older versions kept the address of one server.
void read_servers(const toml::table& table, Preferences& preferences) {
  if (const auto server = table["server"].value<std::string>(); server && !server->empty())
    preferences.servers.push_back({.address = *server});
  const toml::array* servers = table["servers"].as_array();
  if (!servers) return;
  for (const toml::node& node : *servers) {
    const toml::table* entry = node.as_table();
    if (!entry || preferences.servers.size() == kKnownServersMax) continue;
    KnownServer server;
    read(*entry, "address", server.address);
    read(*entry, "tls", server.tls);
    read(*entry, "user", server.user);
    read(*entry, "token", server.token);
    server.ca = (*entry)["ca"].value_or(std::string());
    server.keeps_token = !server.token.empty();
    preferences.servers.push_back(server);
  }
}

toml::array servers_to_toml(const std::vector<KnownServer>& servers) {
  toml::array array;
  for (const KnownServer& server : servers) {
    toml::table entry{{"address", server.address},
                      {"tls", server.tls},
                      {"ca", server.ca.string()},
                      {"user", server.user}};
    if (server.keeps_token) entry.insert("token", server.token);
    array.push_back(std::move(entry));
  }
  return array;
}

void read_folders(const toml::table& table, Preferences& preferences) {
  const toml::array* folders = table["folders"].as_array();
  if (!folders) return;
  for (const toml::node& node : *folders)
    if (const auto folder = node.value<std::string>();
        folder && preferences.folders.size() < kRecentFoldersMax)
      preferences.folders.emplace_back(*folder);
}

toml::table to_toml(const Preferences& preferences) {
  toml::array recent;
  for (const RecentSession& session : preferences.recent)
    recent.push_back(toml::table{{"server", session.server},
                                 {"session", session.session},
                                 {"scan", session.scan},
                                 {"id", session.id},
                                 {"scan_name", session.scan_name},
                                 {"shown", session.shown_unix_seconds},
                                 {"size_bytes", static_cast<int64_t>(session.size_bytes)}});
  toml::array folders;
  for (const std::filesystem::path& folder : preferences.folders)
    folders.push_back(folder.string());
  toml::table keys;
  for (const auto& [action, key] : preferences.keys) keys.insert(action, key);
  return toml::table{{"user", preferences.user},
                     {"brush_radius_part", preferences.brush_radius_part},
                     {"brush_strength", preferences.brush_strength},
                     {"brush_beta", preferences.brush_beta},
                     {"pen_pressure", preferences.pen_pressure},
                     {"light_theme", preferences.light_theme},
                     {"scale", preferences.scale},
                     {"window_width", preferences.window_width},
                     {"window_height", preferences.window_height},
                     {"light", to_toml(preferences.lighting)},
                     {"native_dialogs", preferences.native_dialogs},
                     {"folders", folders},
                     {"servers", servers_to_toml(preferences.servers)},
                     {"recent", recent},
                     {"keys", keys}};
}

}  // namespace

Result<Preferences> read_preferences(const std::filesystem::path& path) {
  Preferences preferences;
  std::error_code ignored;
  if (path.empty() || !std::filesystem::exists(path, ignored)) return preferences;
  try {
    const toml::table table = toml::parse_file(path.string());
    read_numbers(table, preferences);
    read(table, "native_dialogs", preferences.native_dialogs);
    read_folders(table, preferences);
    read_servers(table, preferences);
    read_recent(table, preferences);
    if (const toml::table* light = table["light"].as_table())
      preferences.lighting = lighting_of(*light);
    if (const toml::table* keys = table["keys"].as_table())
      for (const auto& [action, key] : *keys)
        preferences.keys[std::string(action.str())] = key.value_or(std::string());
  } catch (const toml::parse_error& error) {
    return invalid_argument(path.string() + ":" + std::to_string(error.source().begin.line) + ": " +
                            std::string(error.description()));
  }
  Bindings bindings;
  for (const auto& [action, key] : preferences.keys) {
    const Status bound = bindings.bind(action, key);
    if (!bound.is_ok()) return bound.with_context(path.string());
  }
  return preferences;
}

void remember_folder(Preferences& preferences, const std::filesystem::path& folder) {
  if (folder.empty()) return;
  std::erase(preferences.folders, folder);
  preferences.folders.insert(preferences.folders.begin(), folder);
  if (preferences.folders.size() > kRecentFoldersMax) preferences.folders.resize(kRecentFoldersMax);
}

Status write_preferences(const Preferences& preferences, const std::filesystem::path& path) {
  if (path.empty()) return Status::ok();
  std::error_code error;
  const auto folder = std::filesystem::absolute(path).parent_path();
  if (!std::filesystem::exists(folder, error)) RETURN_IF_ERROR(make_private_folder(folder));
  if (error) return errno_status("cannot make " + folder.string(), error.value());
  std::ostringstream text;
  text << to_toml(preferences) << "\n";
  return write_file(path, text.str(), FileAccess::kUserOnly);
}

}  // namespace burnish
