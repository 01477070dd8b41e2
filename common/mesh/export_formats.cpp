#include "common/mesh/export_formats.h"

#include <algorithm>

namespace burnish {

std::vector<MeshFormat> export_formats(MeshFormat own) {
  std::vector<MeshFormat> formats;
  for (const MeshFormatFacts& known : kMeshFormats)
    if (known.is_written_for_any_scan) formats.push_back(known.format);
  const auto found = std::ranges::find(formats, own);
  if (found != formats.end()) std::rotate(formats.begin(), found, found + 1);
  if (own == MeshFormat::kZip) formats.insert(formats.begin(), own);
  return formats;
}

}  // namespace burnish
