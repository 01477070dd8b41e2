#pragma once

#include <string>

namespace burnish {

/// What 127.0.0.1:port answers to "GET /metrics"; empty when nobody does.
std::string http_get_metrics(int port);

/// The value of one line of metrics, e.g. "burnish_live_objects{kind=\"call\"}"; -1: no such line.
double metric(const std::string& text, const std::string& name);

}  // namespace burnish
