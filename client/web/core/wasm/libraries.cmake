# The libraries of Debian that have no build for WASI, from their sources.

set(BURNISH_WEB_FLAGS -Oz -flto -fvisibility=hidden -fno-exceptions -fno-rtti -ffunction-sections -fdata-sections
  -fwhole-program-vtables -fvirtual-function-elimination)

file(GLOB zstd_sources ${BURNISH_WEB_SOURCES}/libzstd/lib/common/*.c
                       ${BURNISH_WEB_SOURCES}/libzstd/lib/decompress/*.c)
if(NOT zstd_sources)
  message(FATAL_ERROR "no sources of libzstd in ${BURNISH_WEB_SOURCES}: 'deploy/setup --web' fetches them")
endif()
list(FILTER zstd_sources EXCLUDE REGEX "(pool|threading)\\.c$")
add_library(zstd OBJECT ${zstd_sources})
target_include_directories(zstd SYSTEM PUBLIC ${BURNISH_WEB_SOURCES}/libzstd/lib)
# The last three are the library's own advice for a small decoder.
target_compile_definitions(zstd PRIVATE ZSTD_DISABLE_ASM=1 NDEBUG HUF_FORCE_DECOMPRESS_X1
  ZSTD_FORCE_DECOMPRESS_SEQUENCES_SHORT ZSTD_STRIP_ERROR_STRINGS)
target_compile_options(zstd PRIVATE ${BURNISH_WEB_FLAGS} -w)

# The list of its own build, libprotobuf_lite_la_SOURCES.
set(protobuf ${BURNISH_WEB_SOURCES}/protobuf/src)
set(protobuf_sources)
foreach(name any_lite arena arenastring arenaz_sampler extension_set generated_enum_util
        generated_message_tctable_lite generated_message_util implicit_weak_message
        inlined_string_field io/coded_stream io/strtod io/zero_copy_stream io/zero_copy_stream_impl
        io/zero_copy_stream_impl_lite map message_lite parse_context repeated_field
        repeated_ptr_field stubs/bytestream stubs/common stubs/int128 stubs/status stubs/statusor
        stubs/stringpiece stubs/stringprintf stubs/structurally_valid stubs/strutil stubs/time
        wire_format_lite)
  list(APPEND protobuf_sources ${protobuf}/google/protobuf/${name}.cc)
endforeach()
add_library(protobuf OBJECT ${protobuf_sources})
# Before the library's own headers: <mutex> with the locks that it takes.
target_include_directories(protobuf SYSTEM PUBLIC ${core}/wasm/threadless ${protobuf})
target_compile_definitions(protobuf PUBLIC GOOGLE_PROTOBUF_NO_RTTI PRIVATE NDEBUG)
target_compile_options(protobuf PRIVATE ${BURNISH_WEB_FLAGS} -w)

find_program(PROTOC protoc REQUIRED)
set(generated ${CMAKE_CURRENT_BINARY_DIR}/proto)
file(MAKE_DIRECTORY ${generated})
set(messages)
foreach(name common library editing)
  set(stem ${generated}/burnish/v1/${name})
  add_custom_command(
    OUTPUT ${stem}.pb.cc ${stem}.pb.h
    COMMAND ${PROTOC} -I ${root}/proto --cpp_out=lite:${generated} burnish/v1/${name}.proto
    DEPENDS ${root}/proto/burnish/v1/${name}.proto ${root}/proto/burnish/v1/common.proto
    COMMENT "Generating burnish/v1/${name}.proto" VERBATIM)
  list(APPEND messages ${stem}.pb.cc)
endforeach()
add_library(proto OBJECT ${messages})
target_include_directories(proto SYSTEM PUBLIC ${generated})
target_link_libraries(proto PUBLIC protobuf)
target_compile_options(proto PRIVATE ${BURNISH_WEB_FLAGS} -w)
