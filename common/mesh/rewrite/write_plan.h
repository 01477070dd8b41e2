#pragma once

#include <string>
#include <vector>

#include "common/base/status.h"
#include "common/mesh/mesh_format.h"
#include "common/mesh/rewrite/rewrite.h"

namespace burnish {

/// How a scan is written in a format.
enum class WriteWay {
  kRewrite,  ///< its file with other numbers
  kUnpack,   ///< the mesh of its archive with other numbers
  kPack,     ///< its file with other numbers, in an archive
  kConvert,  ///< what the other format has
};

/// Finds the way from a file to a format. This is the table of docs/formats.md. `mesh` is the
/// format of the mesh in an archive, else the file's. `name` is for the message. Fails:
/// invalid_argument if there is none.
Result<WriteWay> find_way(MeshFormat file, MeshFormat mesh, MeshFormat to, const std::string& name);

struct WritePlan {
  WriteWay way = WriteWay::kConvert;
  std::string name;                  ///< of the original, for messages
  std::vector<std::string> buffers;  ///< files beside the mesh that change too: as glTF names them
};

/// Plans before long work how a scan is written. Fails: as find_way(); as the file cannot be read.
Result<WritePlan> plan_to_write(const OriginalFile& original, MeshFormat to);

/// Checks that the plan writes the mesh file alone. Fails: invalid_argument.
Status check_one_file(const WritePlan& plan);

}  // namespace burnish
