#include "server/prepare/prepared_mesh.h"

#include <algorithm>
#include <utility>

#include "common/base/atomic_file.h"
#include "common/base/file_content.h"
#include "common/base/loop_progress.h"
#include "server/lease/leased_file.h"
#include "server/prepare/prepared_file.h"

namespace burnish {

uint64_t PreparedMesh::byte_count() const {
  uint64_t total = 0;
  for (const auto& section : section_bytes(*this)) total += section.size();
  return total;
}

/// Writes a section in pieces, each a fraction of a second.
static Status write_section(std::span<const uint8_t> section, LoopProgress& loop,
                            AtomicFile& file) {
  constexpr size_t kPieceBytes = size_t{16} << 20;
  for (; !section.empty(); section = section.subspan(std::min(kPieceBytes, section.size()))) {
    if (!loop.goes_on(0)) return cancelled("storing the prepared mesh was cancelled");
    RETURN_IF_ERROR(file.write(section.first(std::min(kPieceBytes, section.size()))));
  }
  return Status::ok();
}

Status write_prepared_mesh(const PreparedMesh& prepared, const std::filesystem::path& path,
                           const Progress& progress) {
  static constexpr std::array<uint8_t, kSectionAlignment> kZeros = {};
  const PreparedHeader header = make_prepared_header(prepared);
  const auto sections = section_bytes(prepared);
  ASSIGN_OR_RETURN(AtomicFile file, AtomicFile::create(path));
  RETURN_IF_ERROR(file.write({reinterpret_cast<const uint8_t*>(&header), sizeof(header)}));
  LoopProgress loop(progress, "storing", 0, 0);
  uint64_t end = sizeof(header);
  for (int i = 0; i < kPreparedSections; ++i) {
    RETURN_IF_ERROR(file.write(std::span(kZeros).first(header.sections[i].offset - end)));
    RETURN_IF_ERROR(write_section(sections[i], loop, file));
    end = header.sections[i].offset + sections[i].size();
  }
  return file.commit();
}

static std::string name_of(const std::filesystem::path& path) {
  return "prepared mesh " + path.string();
}

template <typename Storage>
static Result<std::shared_ptr<const PreparedMesh>> checked_mesh(const std::filesystem::path& path,
                                                                Storage bytes, bool is_in_file) {
  const auto storage = std::make_shared<const Storage>(std::move(bytes));
  Result<PreparedMesh> mesh = parse_prepared_file(storage->bytes());
  if (!mesh.is_ok()) return mesh.status().with_context(name_of(path));
  mesh->storage = storage;
  mesh->is_in_file = is_in_file;
  return std::make_shared<const PreparedMesh>(std::move(mesh).value());
}

Result<std::shared_ptr<const PreparedMesh>> read_prepared_mesh(const std::filesystem::path& path,
                                                               const ScratchSpace& space) {
  ASSIGN_OR_RETURN(FileContent copy, FileContent::read(path, space));
  return checked_mesh(path, std::move(copy), space.memory_bytes() == 0);
}

Result<std::shared_ptr<const PreparedMesh>> hold_prepared_mesh(
    const std::filesystem::path& path, const std::filesystem::path& folder) {
  ASSIGN_OR_RETURN(LeasedFile held, LeasedFile::open(path, folder));
  return checked_mesh(path, std::move(held), true);
}

static Result<PreparedHeader> read_prepared_header(const std::filesystem::path& path) {
  ASSIGN_OR_RETURN(const FileContent head,
                   FileContent::read_beginning(path, sizeof(PreparedHeader)));
  const auto header = parse_prepared_header(head.bytes(), head.file_bytes());
  if (!header.is_ok()) return header.status().with_context(name_of(path));
  return header;
}

Result<PreparedSummary> read_prepared_summary(const std::filesystem::path& path) {
  ASSIGN_OR_RETURN(const PreparedHeader header, read_prepared_header(path));
  return summary_of(header);
}

Result<uint64_t> read_prepared_checksum(const std::filesystem::path& path) {
  ASSIGN_OR_RETURN(const PreparedHeader header, read_prepared_header(path));
  return header.checksum;
}

}  // namespace burnish
