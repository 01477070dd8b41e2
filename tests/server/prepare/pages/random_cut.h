#pragma once

#include <cstdint>

#include "common/pages/cut.h"
#include "common/pages/directory.h"

namespace burnish {

/// Makes a legal cut in one of three ways: any pages and what they need; detail around a place;
/// pages that arrived one by one until some moment.
PageSet random_legal_cut(const PageDirectory& directory, uint32_t seed);

}  // namespace burnish
