#pragma once

#include <span>
#include <string>

#include "common/base/status.h"
#include "tests/bench/report.h"

namespace burnish {

/// Times filters of scans as a drag of the edge angle asks for them, on processors and on a device
/// if there is one. `scans`: files or "KIND:VERTICES"; without any a tablet of a million triangles.
/// Fails: invalid_argument that names a scan; as filters do.
Status report_live(std::span<const std::string> scans, BenchReport& report);

}  // namespace burnish
