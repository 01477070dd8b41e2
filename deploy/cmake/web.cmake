# Sets BURNISH_WEB to ON or OFF for the rest of the tree: whether to build the editor for browsers.
# Where it is on, BURNISH_CORE_FOLDER has its cores, compiled from the client's sources.

set(BURNISH_WEB_SOURCES /usr/local/src/burnish CACHE PATH
    "Folder with the sources of libzstd: deploy/setup --web fetches them")
if(BURNISH_WEB STREQUAL "AUTO")
  set(BURNISH_WEB ON)
  foreach(program clang++-19 wasm-ld-19 esbuild brotli)
    string(MAKE_C_IDENTIFIER "BURNISH_${program}" found)
    find_program(${found} ${program})
    if(NOT ${found})
      set(BURNISH_WEB OFF)
    endif()
  endforeach()
  foreach(file ${BURNISH_WEB_SOURCES}/libzstd/lib/zstd.h ${PROJECT_SOURCE_DIR}/node_modules/preact/package.json)
    if(NOT EXISTS ${file})
      set(BURNISH_WEB OFF)
    endif()
  endforeach()
  if(BURNISH_SANITIZE)
    set(BURNISH_WEB OFF)
  endif()
  message(STATUS "Editor for browsers: ${BURNISH_WEB}")
endif()

# The cores are a project of their own, for another compiler; ninja knows its sources.
if(BURNISH_WEB)
  set(BURNISH_CORE_FOLDER ${PROJECT_BINARY_DIR}/web-core)
  add_custom_target(burnish_core_wasm
    COMMAND ${PROJECT_SOURCE_DIR}/client/web/core/wasm/build ${BURNISH_CORE_FOLDER} ${BURNISH_WEB_SOURCES} ${BURNISH_WERROR}
    BYPRODUCTS ${BURNISH_CORE_FOLDER}/core.wasm ${BURNISH_CORE_FOLDER}/core_raster.wasm
    COMMENT "Compiling the cores for browsers" USES_TERMINAL VERBATIM)
  add_subdirectory(client/web)
endif()
