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

# The messages, in a form of their own: client/web/core/messages/message.h says why.
find_program(PROTOC protoc REQUIRED)
set(generated ${CMAKE_CURRENT_BINARY_DIR}/proto)
file(MAKE_DIRECTORY ${generated})
set(plugin ${core}/messages/protoc-gen-messages)
set(messages)
foreach(name common library editing)
  set(stem ${generated}/burnish/v1/${name})
  add_custom_command(
    OUTPUT ${stem}.pb.cc ${stem}.pb.h
    COMMAND ${PROTOC} -I ${root}/proto --plugin=${plugin} --messages_out=${generated} burnish/v1/${name}.proto
    DEPENDS ${plugin} ${root}/proto/burnish/v1/${name}.proto ${root}/proto/burnish/v1/common.proto
    COMMENT "Generating burnish/v1/${name}.proto" VERBATIM)
  list(APPEND messages ${stem}.pb.cc)
endforeach()
add_library(proto OBJECT ${messages})
target_include_directories(proto PUBLIC ${root} PUBLIC ${generated})
target_compile_options(proto PRIVATE ${BURNISH_WEB_FLAGS})
