#include "server/library/mesh_cache.h"

namespace burnish {

std::shared_ptr<const SharedMesh> MeshCache::find(const Key& key) {
  const std::lock_guard lock(mutex_);
  const auto found = meshes_.find(key);
  return found == meshes_.end() ? nullptr : found->second.lock();
}

void MeshCache::add(const Key& key, const std::shared_ptr<const SharedMesh>& mesh) {
  const std::lock_guard lock(mutex_);
  std::erase_if(meshes_, [](const auto& entry) { return entry.second.expired(); });
  meshes_[key] = mesh;
}

uint64_t MeshCache::byte_count() const {
  const std::lock_guard lock(mutex_);
  uint64_t bytes = 0;
  for (const auto& [key, mesh] : meshes_)
    if (const auto held = mesh.lock()) bytes += held->byte_count();
  return bytes;
}

}  // namespace burnish
