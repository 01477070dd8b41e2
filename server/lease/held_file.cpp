#include "server/lease/held_file.h"

namespace burnish {

Result<HeldFile> HeldFile::open(const std::filesystem::path& path) {
  auto leased = LeasedFile::open(path, path.parent_path());
  if (leased.is_ok()) return HeldFile(std::move(leased).value());
  ASSIGN_OR_RETURN(MappedFile mapped, MappedFile::open(path));
  return HeldFile(std::move(mapped));
}

std::span<const uint8_t> HeldFile::bytes() const {
  return std::visit([](const auto& file) { return file.bytes(); }, file_);
}

}  // namespace burnish
