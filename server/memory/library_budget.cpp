#include "server/memory/library_budget.h"

#include <algorithm>

#include "common/base/limits.h"
#include "common/base/process_memory.h"
#include "common/grid/depth_plan.h"
#include "common/mesh/io/mesh_io.h"
#include "server/memory/opening_need.h"

namespace burnish {

LibraryBudget::LibraryBudget(Quota& memory, std::filesystem::path folder, uint64_t device_bytes_max)
    : memory_(memory),
      folder_(std::move(folder)),
      device_bytes_max_(device_bytes_max),
      bytes_max_(std::min({memory.max(), available_memory_bytes(), machine_memory_bytes()})),
      space_(folder_, bytes_max_ / kPartForArrays) {}

Status LibraryBudget::take(uint64_t bytes) {
  if (bytes > bytes_max_ && bytes_max_ < memory_.max())
    return resource_exhausted(std::to_string(bytes) +
                              " bytes of memory are needed; the machine has " +
                              std::to_string(bytes_max_) + " available");
  if (share_.amount() > 0) return share_.resize(bytes);
  ASSIGN_OR_RETURN(share_, memory_.take(kServer, bytes));
  return Status::ok();
}

Status LibraryBudget::ask_to_read(const std::filesystem::path& file, MeshFormat format) {
  ASSIGN_OR_RETURN(const uint64_t bytes, reading_bytes_max(file, format));
  reading_bytes_ = bytes;
  if (!is_read_into_scratch(format)) return take(bytes).with_context("reading the mesh file");
  const uint64_t in_memory = std::min(bytes, space_.memory_bytes_max());
  RETURN_IF_ERROR(check_disk_space(folder_, bytes - in_memory));
  return take(in_memory).with_context("reading the mesh file");
}

Status LibraryBudget::ask_for_picture(uint64_t bytes) {
  return take(reading_bytes_ + bytes).with_context("decoding it");
}

Status LibraryBudget::ask(const PreparationNeed& need) {
  const uint64_t opened = predict_opened_bytes(need, device_bytes_max_);
  if (opened > memory_.max())
    return resource_exhausted("a session at that depth takes " + std::to_string(opened) +
                              " bytes; limits.memory_bytes_max is " +
                              std::to_string(memory_.max()));
  const uint64_t scratch = need.scratch_bytes - std::min(need.scratch_bytes, space_.file_bytes());
  RETURN_IF_ERROR(check_disk_space(folder_, need.file_bytes + scratch));
  return take(need.memory_bytes);
}

// A session takes fewer bytes on the device than scan and session take in memory.
uint64_t LibraryBudget::default_depth_bytes_max() const {
  const uint64_t bytes =
      device_bytes_max_ == 0 ? memory_.max() : std::min(memory_.max(), device_bytes_max_);
  return memory_of_default_depth(bytes);
}

uint64_t LibraryBudget::scratch_bytes_max() const {
  std::error_code error;
  const std::filesystem::space_info space = std::filesystem::space(folder_, error);
  return error ? 0 : space.available;
}

Status check_disk_space(const std::filesystem::path& folder, uint64_t bytes) {
  std::error_code error;
  const std::filesystem::space_info space = std::filesystem::space(folder, error);
  if (error) return errno_status("cannot find the free space in " + folder.string(), error.value());
  const uint64_t usable = space.available - std::min(space.available, kDiskReserveBytes);
  if (bytes <= usable) return Status::ok();
  return resource_exhausted(
      std::to_string(bytes) +
      " bytes do not fit on the disk of the data folder: " + std::to_string(space.available) +
      " are free, and " + std::to_string(kDiskReserveBytes) + " of them are for the journal");
}

}  // namespace burnish
