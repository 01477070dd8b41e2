#pragma once

#include <string>

namespace burnish {

/// Returns the answer of 127.0.0.1:port to "GET /metrics"; empty without an answer.
std::string http_get_metrics(int port);

/// Returns the value of one line of metrics, e.g. "burnish_live_objects{kind=\"call\"}"; -1 if
/// there is none.
double metric(const std::string& text, const std::string& name);

}  // namespace burnish
