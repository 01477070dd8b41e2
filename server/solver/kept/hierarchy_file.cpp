#include "server/solver/kept/hierarchy_file.h"

#include <algorithm>
#include <cstring>
#include <string_view>
#include <xxhash.h>

#include "common/base/atomic_file.h"
#include "common/base/file_reader.h"
#include "common/base/loop_progress.h"
#include "common/base/resize_touched.h"
#include "server/solver/kept/hierarchy_checks.h"
#include "server/solver/kept/hierarchy_format.h"

namespace burnish {

namespace {

constexpr std::array<uint8_t, kSectionAlignment> kZeros = {};
constexpr size_t kPieceBytes = size_t{256} << 10;  // stays in a processor's cache

template <typename T>
std::span<const uint8_t> bytes_of(std::span<const T> values) {
  return {reinterpret_cast<const uint8_t*>(values.data()), values.size_bytes()};
}

template <typename T>
constexpr size_t piece_of() {
  return kPieceBytes / sizeof(T);
}

// Copies a struct with padding to bytes that are zero.
void copy_fields(const GridKey& from, GridKey& to) {
  to.place = from.place;
  to.component = from.component;
}
void copy_fields(const FromCell& from, FromCell& to) {
  to.cell = from.cell;
  to.place = from.place;
}
void copy_fields(const CellTie& from, CellTie& to) {
  to.first = from.first;
  to.second = from.second;
  to.first_corners = from.first_corners;
  to.second_corners = from.second_corners;
}

template <typename T>
concept Padded = requires(const T& from, T& to) {
  copy_fields(from, to);
};

/// Calls take(bytes) for an array's pieces, in the order of a file, until take() fails.
template <typename T>
Status for_each_piece(const std::vector<T>& values, const auto& take) {
  std::vector<T> clean;
  for (size_t at = 0; at < values.size(); at += piece_of<T>()) {
    std::span<const T> piece(values.data() + at, std::min(piece_of<T>(), values.size() - at));
    if constexpr (Padded<T>) {
      clean.resize(piece.size());
      std::memset(static_cast<void*>(clean.data()), 0, piece.size_bytes());
      for (size_t i = 0; i < piece.size(); ++i) copy_fields(piece[i], clean[i]);
      piece = clean;
    }
    RETURN_IF_ERROR(take(bytes_of(piece)));
  }
  return Status::ok();
}

/// The XXH3 of bytes that come in pieces.
class PieceChecksum {
 public:
  PieceChecksum() { XXH3_64bits_reset(state_.get()); }
  void add(std::span<const uint8_t> bytes) {
    XXH3_64bits_update(state_.get(), bytes.data(), bytes.size());
  }
  uint64_t value() const { return XXH3_64bits_digest(state_.get()); }

 private:
  std::unique_ptr<XXH3_state_t, XXH_errorcode (*)(XXH3_state_t*)> state_{XXH3_createState(),
                                                                         XXH3_freeState};
};

constexpr uint64_t table_end(size_t sections) {
  return sizeof(HierarchyHeader) + sections * sizeof(SectionEntry);
}

/// Returns the table without checksums, and the length of the file.
std::pair<std::vector<SectionEntry>, uint64_t> lay_out(const Multigrid& of) {
  std::vector<SectionEntry> table;
  visit_arrays(*of.hierarchy, *of.plan, [&]<typename T>(const char*, const std::vector<T>& array) {
    table.push_back({static_cast<uint32_t>(table.size()), sizeof(T), array.size(), 0, 0});
  });
  uint64_t end = table_end(table.size());
  for (SectionEntry& entry : table) {
    entry.offset = align_section(end);
    end = entry.offset + entry.count * entry.element_bytes;
  }
  return {std::move(table), end};
}

HierarchyHeader header_of(const Multigrid& of, uint64_t fingerprint) {
  HierarchyHeader header = {};
  header.magic = kHierarchyMagic;
  header.version = kHierarchyFormatVersion;
  header.coarsest = of.hierarchy->coarsest;
  header.finest = of.hierarchy->finest;
  header.first_weak_depth = of.plan->first_weak_depth;
  header.has_flat_parts = of.plan->has_flat_parts;
  header.sheet_count = of.hierarchy->depths.back().sheet_count;
  header.fingerprint = fingerprint;
  return header;
}

/// Hands over an array's pieces while nobody cancels.
template <typename T>
Status for_each_heard_piece(const std::vector<T>& array, LoopProgress& loop, const auto& take) {
  return for_each_piece(array, [&](std::span<const uint8_t> piece) {
    if (!loop.goes_on(0)) return cancelled("storing the hierarchy was cancelled");
    return take(piece);
  });
}

Status sum_up(const Multigrid& of, std::vector<SectionEntry>& table, LoopProgress& loop) {
  Status status;
  auto entry = table.begin();
  visit_arrays(*of.hierarchy, *of.plan, [&](const char*, const auto& array) {
    PieceChecksum sum;
    if (status.is_ok())
      status = for_each_heard_piece(array, loop, [&](std::span<const uint8_t> piece) {
        sum.add(piece);
        return Status::ok();
      });
    (entry++)->checksum = sum.value();
  });
  return status;
}

Status write_sections(const Multigrid& of, const std::vector<SectionEntry>& table,
                      LoopProgress& loop, AtomicFile& file) {
  Status status;
  auto entry = table.begin();
  uint64_t end = table_end(table.size());
  visit_arrays(*of.hierarchy, *of.plan, [&](const char*, const auto& array) {
    if (status.is_ok()) status = file.write(std::span(kZeros).first(entry->offset - end));
    const auto write = [&](std::span<const uint8_t> piece) { return file.write(piece); };
    if (status.is_ok()) status = for_each_heard_piece(array, loop, write);
    end = entry->offset + entry->count * entry->element_bytes;
    ++entry;
  });
  return status;
}

/// An array of the file in memory.
struct Section {
  const SectionEntry& entry;
  std::string name;
  std::span<uint8_t> bytes;
};

template <typename T>
std::span<uint8_t> make_room(std::vector<T>& array, size_t count) {
  array.clear();
  resize_touched(array, count);
  return {reinterpret_cast<uint8_t*>(array.data()), count * sizeof(T)};
}

Status check_sums(const std::vector<Section>& sections) {
  std::vector<uint8_t> is_whole(sections.size());
#pragma omp parallel for schedule(dynamic)
  for (size_t i = 0; i < sections.size(); ++i) {
    const std::span<const uint8_t> bytes = sections[i].bytes;
    is_whole[i] = XXH3_64bits(bytes.data(), bytes.size()) == sections[i].entry.checksum;
  }
  for (size_t i = 0; i < sections.size(); ++i)
    if (is_whole[i] == 0)
      return data_loss("section " + sections[i].name + ": its checksum is wrong");
  return Status::ok();
}

Status read_arrays(const FileReader& file, std::span<const SectionEntry> table,
                   const Progress& progress, Hierarchy& hierarchy, CyclePlan& plan) {
  LoopProgress loop(progress, "opening", 0, 0);
  const auto goes_on = [&] { return loop.goes_on(0); };
  // Asked here, because a small file may be read before the first thread has its turn.
  if (!goes_on()) return cancelled("opening was cancelled");
  std::vector<Section> sections;
  Status status;
  visit_arrays(hierarchy, plan, [&]<typename T>(const char* name, std::vector<T>& array) {
    if (!status.is_ok()) return;
    const SectionEntry& entry = table[sections.size()];
    sections.push_back(
        {entry, std::to_string(sections.size()) + ", " + name, make_room(array, entry.count)});
    status = file.read_together(entry.offset, sections.back().bytes, goes_on)
                 .with_context("section " + sections.back().name);
  });
  RETURN_IF_ERROR(status);
  return check_sums(sections);
}

std::vector<uint32_t> element_sizes(Hierarchy& hierarchy, CyclePlan& plan) {
  std::vector<uint32_t> sizes;
  visit_arrays(hierarchy, plan,
               [&]<typename T>(const char*, const std::vector<T>&) { sizes.push_back(sizeof(T)); });
  return sizes;
}

// Makes the depths, without their arrays.
void take_scalars(const HierarchyHeader& header, Hierarchy& hierarchy, CyclePlan& plan) {
  hierarchy.coarsest = header.coarsest;
  hierarchy.finest = header.finest;
  hierarchy.depths.resize(header.finest - header.coarsest + 1);
  for (int depth = header.coarsest; depth <= header.finest; ++depth)
    hierarchy.depths[depth - header.coarsest].grid.depth = depth;
  hierarchy.depths.back().sheet_count = header.sheet_count;
  plan.first_weak_depth = header.first_weak_depth;
  plan.has_flat_parts = header.has_flat_parts != 0;
}

Result<HierarchyHeader> read_header(const FileReader& file, uint64_t fingerprint, int depth) {
  HierarchyHeader header = {};
  if (file.file_bytes() < sizeof(header))
    return data_loss("length of the file is " + std::to_string(file.file_bytes()) +
                     ", its header needs " + std::to_string(sizeof(header)));
  RETURN_IF_ERROR(file.read(0, {reinterpret_cast<uint8_t*>(&header), sizeof(header)}));
  RETURN_IF_ERROR(check_hierarchy_header(header, fingerprint, depth, file.file_bytes()));
  return header;
}

Result<Multigrid> read_from(const FileReader& file, std::shared_ptr<const PreparedMesh> prepared,
                            uint64_t fingerprint, const Progress& progress) {
  ASSIGN_OR_RETURN(const HierarchyHeader header,
                   read_header(file, fingerprint, prepared->frame.depth));
  const auto hierarchy = std::make_shared<Hierarchy>();
  const auto plan = std::make_shared<CyclePlan>();
  take_scalars(header, *hierarchy, *plan);
  std::vector<SectionEntry> table(header.section_count);
  RETURN_IF_ERROR(file.read(sizeof(header), {reinterpret_cast<uint8_t*>(table.data()),
                                             table.size() * sizeof(SectionEntry)}));
  RETURN_IF_ERROR(check_hierarchy_table(header, table, element_sizes(*hierarchy, *plan)));
  RETURN_IF_ERROR(read_arrays(file, table, progress, *hierarchy, *plan));
  RETURN_IF_ERROR(check_and_complete(*hierarchy, *plan, *prepared));
  return Multigrid{std::move(prepared), hierarchy, plan};
}

}  // namespace

uint64_t hierarchy_fingerprint(uint64_t prepared_checksum) {
  static constexpr std::string_view kRelease = BURNISH_VERSION;
  return XXH3_64bits_withSeed(kRelease.data(), kRelease.size(), prepared_checksum);
}

uint64_t hierarchy_file_bytes(const Multigrid& of) {
  return lay_out(of).second;
}

Status write_hierarchy(const Multigrid& of, uint64_t fingerprint, const std::filesystem::path& path,
                       const Progress& progress) {
  LoopProgress loop(progress, "storing", 0, 0);
  HierarchyHeader header = header_of(of, fingerprint);
  auto [table, end] = lay_out(of);
  RETURN_IF_ERROR(sum_up(of, table, loop));
  header.section_count = table.size();
  header.file_bytes = end;
  header.checksum = hierarchy_checksum(header, table);
  ASSIGN_OR_RETURN(AtomicFile file, AtomicFile::create(path));
  RETURN_IF_ERROR(file.write(bytes_of(std::span<const HierarchyHeader>(&header, 1))));
  RETURN_IF_ERROR(file.write(bytes_of(std::span<const SectionEntry>(table))));
  RETURN_IF_ERROR(write_sections(of, table, loop, file));
  return file.commit();
}

Result<Multigrid> read_hierarchy(const std::filesystem::path& path,
                                 std::shared_ptr<const PreparedMesh> prepared, uint64_t fingerprint,
                                 const Progress& progress) {
  ASSIGN_OR_RETURN(const FileReader file, FileReader::open(path));
  auto read = read_from(file, std::move(prepared), fingerprint, progress);
  if (!read.is_ok()) return read.status().with_context("hierarchy " + path.string());
  return read;
}

}  // namespace burnish
