#pragma once

#include "client/model/raw_scan.h"

namespace burnish {

/// Draws what is known of a scan while the server prepares it.
void draw_raw_facts(const RawScan& scan);

}  // namespace burnish
