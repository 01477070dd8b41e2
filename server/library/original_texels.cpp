#include "server/library/original_texels.h"

#include "common/mesh/io/textured_surface.h"
#include "server/lease/held_file.h"
#include "server/library/read_original.h"

namespace burnish {

Result<bool> may_have_pictures(const std::filesystem::path& path, MeshFormat format) {
  ASSIGN_OR_RETURN(const HeldFile file, HeldFile::open(path));
  return may_have_pictures(file.bytes(), format);
}

Result<CountedTexels> texels_of_original(const std::filesystem::path& path, MeshFormat format,
                                         const std::string& name, LibraryBudget& budget,
                                         const Progress& progress) {
  ASSIGN_OR_RETURN(const HeldFile file, HeldFile::open(path));
  CountedTexels texels;
  if (!may_have_pictures(file.bytes(), format)) return texels;
  const auto count = [&](const TexturedSurface& surface) -> Status {
    ASSIGN_OR_RETURN(texels, count_texels(surface.textures, name, budget.space(), progress));
    return Status::ok();
  };
  RETURN_IF_ERROR(read_textured_surface(file.bytes(), format, name, count,
                                        {.budget = reading_budget(budget, progress)}));
  return texels;
}

}  // namespace burnish
