#pragma once

#include <vector>

#include "common/gltf/document.h"

namespace burnish {

/// Private to this folder. Returns for each accessor of a document whether its elements' bytes may
/// belong to something else too: to another accessor, or to another buffer view. Interleaved
/// accessors share no bytes.
std::vector<bool> find_shared_accessors(const GltfDocument& document);

}  // namespace burnish
