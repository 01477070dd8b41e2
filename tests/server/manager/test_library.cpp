#include "tests/server/manager/test_library.h"

#include "common/generate/generate.h"
#include "common/mesh/io/mesh_io.h"
#include "common/transfer/chunk.h"

namespace burnish {

TestLibrary::TestLibrary(const MeshStoreOptions& store_options) : options(store_options) {
  restart();
}

void TestLibrary::restart() {
  store.reset();
  folder.reset();
  folder = std::move(DataFolder::open(root / "data")).value();
  store = std::move(MeshStore::open(*folder, options)).value();
}

Result<ImportOutcome> TestLibrary::import(const std::string& bytes, const std::string& name,
                                          const Progress& progress, int depth, MeshFormat format) {
  const ImportHeader header{name, format, bytes.size(), "", {depth, 0}};
  ASSIGN_OR_RETURN(const auto upload, store->begin_upload(header));
  for (size_t begin = 0; begin < bytes.size(); begin += kChunkBytesMax) {
    const std::string chunk = bytes.substr(begin, kChunkBytesMax);
    RETURN_IF_ERROR(upload->append(begin, chunk, chunk_crc32(chunk)));
  }
  return store->import(*upload, header, progress);
}

size_t TestLibrary::staged_files() const {
  const std::filesystem::directory_iterator files(root / "data/staging");
  return static_cast<size_t>(std::distance(begin(files), end(files)));
}

std::string mesh_file(const TriangleMesh& mesh) {
  const TemporaryFolder folder;
  const auto path = folder / "mesh.ply";
  const Status status = write_mesh(mesh, path);
  BURNISH_CHECK(status.is_ok(), status.message());
  return content_of(path);
}

std::string sphere_file(double radius, int level) {
  return mesh_file(make_icosphere(level, radius));
}

}  // namespace burnish
