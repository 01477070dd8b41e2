#include "server/web/protocol/request_rules.h"

#include <algorithm>
#include <climits>
#include <unistd.h>

#include <arpa/inet.h>

#include "common/base/parse_number.h"
#include "common/base/text.h"

namespace burnish {
namespace {

constexpr size_t kShownBytesMax = 100;

std::string in_lower_case(std::string_view text) {
  std::string lower(text);
  for (char& c : lower)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return lower;
}

/// Returns the name or the numeric address of "burnish.lab:7443", "127.0.0.1" or "[::1]:80", in
/// lower case and without brackets; empty if it is not a host.
std::string name_of(std::string_view host) {
  const size_t bracket = host.find(']');
  const size_t colon = host.find(':', bracket == std::string_view::npos ? 0 : bracket);
  std::string_view name = host.substr(0, colon);
  if (colon != std::string_view::npos && !parse_number<uint16_t>(host.substr(colon + 1))) return {};
  if (name.starts_with('[') && name.ends_with(']')) name = name.substr(1, name.size() - 2);
  return in_lower_case(name);
}

bool is_loopback_name(const std::string& name) {
  in_addr ipv4;
  if (inet_pton(AF_INET, name.c_str(), &ipv4) == 1) return ntohl(ipv4.s_addr) >> 24 == 127;
  return name == "localhost" || name == "::1";
}

Status refused(const char* what, std::string_view value, const std::string& why) {
  return {StatusCode::kPermissionDenied,
          std::string(what) + " '" + one_line(value, kShownBytesMax) + "' " + why};
}

}  // namespace

std::vector<std::string> names_of_this_machine() {
  std::string name(HOST_NAME_MAX + 1, '\0');
  if (gethostname(name.data(), name.size()) != 0) return {};
  name.resize(std::char_traits<char>::length(name.c_str()));
  if (name.empty()) return {};
  const std::string first = name.substr(0, name.find('.'));
  return {name, first, first + ".local"};
}

Status check_host(const RequestRules& rules, std::string_view host,
                  std::string_view local_address) {
  const std::string name = name_of(host);
  const auto is_listed = [&](const std::string& listed) { return in_lower_case(listed) == name; };
  if (!name.empty() && (is_loopback_name(name) || name == local_address ||
                        std::ranges::any_of(rules.hosts, is_listed)))
    return Status::ok();
  return refused("the host", host,
                 "is not a name of this server; --web-host and web.hosts give it more");
}

Status check_origin(const RequestRules& rules, std::string_view origin, std::string_view host) {
  const std::string from = in_lower_case(origin), to = in_lower_case(host);
  if (from.empty() || from == "https://" + to) return Status::ok();
  if (!rules.is_tls && from == "http://" + to) return Status::ok();
  return refused("the origin", origin, "is not that of this server's own page");
}

bool is_for_calls(std::string_view target) {
  return target == "/rpc" || target.starts_with("/rpc?node=");
}

}  // namespace burnish
