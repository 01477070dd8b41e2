# Writes a source with the bytes of files: burnish_carry_files(OUTPUT FILE...). A change of a file
# configures again.
function(burnish_carry_files output)
  set(arrays "")
  set(entries "")
  foreach(file ${ARGN})
    get_filename_component(name "${file}" NAME)
    string(MAKE_C_IDENTIFIER "k_${name}" identifier)
    file(READ "${file}" hex HEX)
    string(REGEX REPLACE "([0-9a-f][0-9a-f])" "'\\\\x\\1'," bytes "${hex}")
    string(APPEND arrays "constexpr char ${identifier}[] = {${bytes}};\n")
    string(APPEND entries "    {\"${name}\", {${identifier}, sizeof(${identifier})}},\n")
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${file}")
  endforeach()
  file(CONFIGURE OUTPUT "${output}" CONTENT "#include \"server/web/web_files.h\"

namespace burnish {
namespace {

@arrays@
constexpr CarriedFile kCarriedFiles[] = {
@entries@};

}  // namespace

std::span<const CarriedFile> carried_files() {
  return kCarriedFiles;
}

}  // namespace burnish
" @ONLY)
endfunction()
