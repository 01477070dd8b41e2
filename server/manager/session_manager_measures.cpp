// The part of SessionManager that measures a session's surface.

#include "server/manager/session_manager_held.h"

namespace burnish {

/// The surface at a moment: what is measured needs no lock.
struct SessionManager::SurfaceCopy {
  Quota::Share memory;
  std::shared_ptr<const SharedMesh> mesh;
  std::vector<Vec3d> vertices;
  bool settled = false;

  const PreparedMesh& before() const { return *mesh->prepared; }
};

// Places before and after, normals, areas and heights, in the largest of the measures.
static constexpr uint64_t kMeasuringBytesPerVertex = 96;

Result<SessionManager::SurfaceCopy> SessionManager::copy_surface(const std::string& reference,
                                                                 const Caller& caller,
                                                                 const Progress& progress) {
  SurfaceCopy copy;
  ASSIGN_OR_RETURN(const Held held, use(reference, caller, progress));
  RETURN_IF_ERROR(catch_up(*held.entry, progress));
  Session& session = *held.entry->session;
  copy.mesh = held.entry->mesh;
  const uint64_t bytes = copy.before().vertices.size() * kMeasuringBytesPerVertex;
  ASSIGN_OR_RETURN(copy.memory, memory().take(kServer, bytes));
  copy.vertices = session.surface().vertices;
  copy.settled = !session.is_changed() && session.is_settled(held.entry->last);
  return copy;
}

Result<SessionDeviation> SessionManager::deviation(const std::string& reference,
                                                   const Caller& caller, const Progress& progress) {
  ASSIGN_OR_RETURN(const SurfaceCopy copy, copy_surface(reference, caller, progress));
  const PreparedMesh& before = copy.before();
  return SessionDeviation{deviation_of(before.vertices, copy.vertices, before.triangles),
                          copy.settled};
}

Result<Section> SessionManager::section(const SectionWish& wish, const Caller& caller,
                                        const Progress& progress) {
  ASSIGN_OR_RETURN(const SurfaceCopy copy, copy_surface(wish.session, caller, progress));
  const PreparedMesh& before = copy.before();
  Section section;
  ASSIGN_OR_RETURN(section.original, cut_surface(before.vertices, before.triangles, wish.plane));
  ASSIGN_OR_RETURN(section.edited, cut_surface(copy.vertices, before.triangles, wish.plane));
  return section;
}

}  // namespace burnish
