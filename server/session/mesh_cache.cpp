#include "server/session/mesh_cache.h"

namespace burnish {

std::shared_ptr<const SharedMesh> MeshCache::find(const Key& key) {
  const std::lock_guard lock(mutex_);
  const auto found = meshes_.find(key);
  return found == meshes_.end() ? nullptr : found->second.lock();
}

Status MeshCache::admit(const Key& key, const std::shared_ptr<const SharedMesh>& mesh) {
  const std::lock_guard lock(mutex_);
  std::erase_if(meshes_, [](const auto& entry) { return entry.second.expired(); });
  uint64_t bytes = 0;
  for (const auto& [other_key, other] : meshes_)
    if (const auto held = other.lock()) bytes += held->byte_count();
  if (bytes + mesh->byte_count() > bytes_max_)
    return resource_exhausted("the scan needs " + std::to_string(mesh->byte_count()) + " bytes; " +
                              std::to_string(bytes) + " of mesh_bytes_max " +
                              std::to_string(bytes_max_) + " are in use");
  meshes_[key] = mesh;
  return Status::ok();
}

}  // namespace burnish
