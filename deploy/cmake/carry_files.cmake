# Writes a source that carries files as they are when it is compiled: burnish_carry_files(OUTPUT NAME FILE...). The
# function NAME() returns them.
function(burnish_carry_files output function)
  set(declarations "")
  set(entries "")
  foreach(file ${ARGN})
    get_filename_component(name "${file}" NAME)
    string(MAKE_C_IDENTIFIER "burnish_${function}_${name}" symbol)
    string(APPEND declarations "asm(\".pushsection .rodata\\n\"
    \".global ${symbol}, ${symbol}_end\\n\"
    \"${symbol}: .incbin \\\"${file}\\\"\\n\"
    \"${symbol}_end: .byte 0\\n\"
    \".popsection\\n\");
extern \"C\" const char ${symbol}[], ${symbol}_end[];
")
    string(APPEND entries "      carried(\"${name}\", ${symbol}, ${symbol}_end),\n")
  endforeach()
  set(returned "  return {};\n")
  if(entries)
    set(returned "  static const CarriedFile files[] = {\n${entries}  };\n  return files;\n")
  endif()
  file(CONFIGURE OUTPUT "${output}" CONTENT "#include <span>

#include \"common/base/carried_file.h\"

// The assembler copies the files.
@declarations@
namespace burnish {

[[maybe_unused]] static CarriedFile carried(std::string_view name, const char* begin,
                                            const char* end) {
  return {name, {begin, static_cast<size_t>(end - begin)}};
}

std::span<const CarriedFile> @function@() {
@returned@}

}  // namespace burnish
" @ONLY)
  # Alone, for the other sources of the folder take minutes.
  set_source_files_properties("${output}" PROPERTIES OBJECT_DEPENDS "${ARGN}" SKIP_UNITY_BUILD_INCLUSION ON)
endfunction()
