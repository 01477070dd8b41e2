# Writes a source that carries files as they are when it is compiled: burnish_carry_files(OUTPUT FILE...).
function(burnish_carry_files output)
  set(declarations "")
  set(entries "")
  foreach(file ${ARGN})
    get_filename_component(name "${file}" NAME)
    string(MAKE_C_IDENTIFIER "burnish_carried_${name}" symbol)
    string(APPEND declarations "asm(\".pushsection .rodata\\n\"
    \".global ${symbol}, ${symbol}_end\\n\"
    \"${symbol}: .incbin \\\"${file}\\\"\\n\"
    \"${symbol}_end: .byte 0\\n\"
    \".popsection\\n\");
extern \"C\" const char ${symbol}[], ${symbol}_end[];
")
    string(APPEND entries "      carried(\"${name}\", ${symbol}, ${symbol}_end),\n")
  endforeach()
  file(CONFIGURE OUTPUT "${output}" CONTENT "#include \"server/web/web_files.h\"

// The assembler copies the files.
@declarations@
namespace burnish {

static CarriedFile carried(std::string_view name, const char* begin, const char* end) {
  return {name, {begin, static_cast<size_t>(end - begin)}};
}

std::span<const CarriedFile> carried_files() {
  static const CarriedFile files[] = {
@entries@  };
  return files;
}

}  // namespace burnish
" @ONLY)
  # Alone, for the other sources of the folder take minutes.
  set_source_files_properties("${output}" PROPERTIES OBJECT_DEPENDS "${ARGN}" SKIP_UNITY_BUILD_INCLUSION ON)
endfunction()
