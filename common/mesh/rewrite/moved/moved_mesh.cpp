#include "common/mesh/rewrite/moved/moved_mesh.h"

#include "common/mesh/reading/text_values.h"

namespace burnish {

Status changed_original(const std::string& name, const std::string& what) {
  return data_loss(name + " is not the file that was read: " + what);
}

Status check_unchanged(const MovedMesh& moved, const std::string& name, uint64_t vertex, int axis,
                       double value) {
  if (vertex >= moved.before.size())
    return changed_original(name, "it has a vertex " + std::to_string(vertex) + ", of " +
                                      std::to_string(moved.before.size()));
  if (moved.before[vertex][axis] == value || !is_coordinate(value)) return Status::ok();
  return changed_original(name, "vertex " + std::to_string(vertex) + " has " + "xyz"[axis] + " = " +
                                    number_text(value) + ", it had " +
                                    number_text(moved.before[vertex][axis]));
}

}  // namespace burnish
