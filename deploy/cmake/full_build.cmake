# What makes a full build quicker and that of one changed source slower: BURNISH_FULL_BUILD turns it
# on. It hides missing includes, which the `dev` preset finds.

set(burnish_common_headers <algorithm> <array> <chrono> <cmath> <cstdint> <filesystem> <functional>
  <map> <memory> <mutex> <optional> <span> <string> <string_view> <utility> <vector>
  <Eigen/Geometry>)

# burnish_precompile(TARGET OWNER HEADER...): parses the headers once, for OWNER; TARGET takes them.
function(burnish_precompile target owner)
  if(NOT BURNISH_FULL_BUILD)
    return()
  endif()
  if(target STREQUAL owner)
    target_precompile_headers(${target} PRIVATE ${ARGN})
  else()
    target_precompile_headers(${target} REUSE_FROM ${owner})
  endif()
endfunction()

# burnish_unity(TARGET): compiles many of its sources as one. Not for hot loops, for what is inlined
# depends on what else is there.
function(burnish_unity target)
  if(BURNISH_FULL_BUILD)
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 16)
    # It takes the anonymous namespaces of sources for those of headers.
    target_compile_options(${target} PRIVATE -Wno-subobject-linkage)
  endif()
endfunction()
