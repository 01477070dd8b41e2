# The packages of the whole tree, and the two functions that make a folder a target.

find_package(Threads REQUIRED)
find_package(Eigen3 3.4 REQUIRED NO_MODULE)
if(BURNISH_OPENMP)
  find_package(OpenMP REQUIRED)
endif()
find_path(XXHASH_INCLUDE_DIR xxhash.h REQUIRED)
find_library(XXHASH_LIBRARY xxhash REQUIRED)
add_library(XXHASH::XXHASH INTERFACE IMPORTED)
target_include_directories(XXHASH::XXHASH INTERFACE ${XXHASH_INCLUDE_DIR})
target_link_libraries(XXHASH::XXHASH INTERFACE ${XXHASH_LIBRARY})
find_package(nlohmann_json 3.11 REQUIRED)
if(BURNISH_SERVICE)
  find_package(Boost 1.74 REQUIRED)  # headers alone
  find_package(OpenSSL REQUIRED COMPONENTS Crypto SSL)
  find_package(Protobuf 3.21 REQUIRED)
  find_package(gRPC 1.51 CONFIG REQUIRED)
  find_package(spdlog REQUIRED)
  find_package(prometheus-cpp REQUIRED CONFIG)  # has no version
  find_package(SQLite3 REQUIRED)
  find_package(PostgreSQL REQUIRED)
  find_package(CURL 7.88 REQUIRED)
  find_package(tomlplusplus 3.3 REQUIRED)
  find_package(ZLIB REQUIRED)
endif()

add_library(burnish_options INTERFACE)
target_include_directories(burnish_options INTERFACE ${PROJECT_SOURCE_DIR})
# False alarms of g++ 12: -Wrestrict on "text" + std::string, the other two on vectors that grow.
target_compile_options(burnish_options INTERFACE "$<$<COMPILE_LANGUAGE:CXX>:\
-Wall;-Wextra;-Wshadow;-Wnon-virtual-dtor;-Wno-missing-field-initializers;\
-Wno-restrict;-Wno-array-bounds;-Wno-stringop-overflow>")
if(BURNISH_WERROR)
  target_compile_options(burnish_options INTERFACE "$<$<COMPILE_LANGUAGE:CXX>:-Werror>")
endif()
# Debian's x86-64 baseline must run everywhere. Hot loops are also compiled for wider registers
# (common/base/dispatch.h). Nothing is contracted and no sum reordered: same input, same bits.
target_compile_options(burnish_options INTERFACE
  "$<$<COMPILE_LANGUAGE:CXX>:-fno-math-errno;-ffp-contract=off>")
target_link_libraries(burnish_options INTERFACE Eigen3::Eigen Threads::Threads)
target_compile_definitions(burnish_options INTERFACE EIGEN_DONT_PARALLELIZE)
if(BURNISH_OPENMP)
  target_link_libraries(burnish_options INTERFACE OpenMP::OpenMP_CXX)
else()
  # OpenMP's flag means -pthread too, which gRPC's targets have: precompiled headers need it in all.
  target_compile_options(burnish_options INTERFACE
    "$<$<COMPILE_LANGUAGE:CXX>:-Wno-unknown-pragmas;-pthread>")
endif()
# A target of its own for generated sources, which take the same sanitizer but no warnings.
add_library(burnish_sanitizer INTERFACE)
if(BURNISH_SANITIZE)
  # With the checks in between, g++ 12 takes members of variants for uninitialised.
  target_compile_options(burnish_sanitizer INTERFACE "$<$<COMPILE_LANGUAGE:CXX>:\
-fsanitize=${BURNISH_SANITIZE};-fno-omit-frame-pointer;-fno-sanitize-recover=all;\
-Wno-maybe-uninitialized>")
  target_link_options(burnish_sanitizer INTERFACE -fsanitize=${BURNISH_SANITIZE})
endif()
if(BURNISH_SANITIZE MATCHES thread)
  add_library(timed_locks OBJECT tests/tsan/timed_locks.cpp)
  target_link_libraries(burnish_sanitizer INTERFACE $<TARGET_OBJECTS:timed_locks>)
  # Asio has fences, which the tool does not follow. Asio's locks order the same accesses.
  target_compile_options(burnish_sanitizer INTERFACE "$<$<COMPILE_LANGUAGE:CXX>:-Wno-tsan>")
endif()
target_link_libraries(burnish_options INTERFACE burnish_sanitizer)

include(deploy/cmake/full_build.cmake)

# burnish_folder(NAME [HOT] SOURCES a.cpp ... DEPENDS burnish_base ...): one folder, one static
# library. HOT: its loops take the time of an edit.
function(burnish_folder name)
  cmake_parse_arguments(arg "HOT" "" "SOURCES;DEPENDS" ${ARGN})
  add_library(${name} STATIC ${arg_SOURCES})
  target_link_libraries(${name} PUBLIC burnish_options ${arg_DEPENDS})
  burnish_precompile(${name} burnish_base ${burnish_common_headers})
  if(NOT arg_HOT)
    burnish_unity(${name})
  endif()
endfunction()

# burnish_test(NAME SOURCES a_test.cpp ... DEPENDS burnish_mesh ...): one test program.
function(burnish_test name)
  cmake_parse_arguments(arg "" "" "SOURCES;DEPENDS" ${ARGN})
  add_executable(${name} ${arg_SOURCES})
  target_link_libraries(${name} PRIVATE ${arg_DEPENDS} GTest::gtest GTest::gmock GTest::gtest_main)
  burnish_precompile(${name} base_test ${burnish_common_headers} <gmock/gmock.h> <gtest/gtest.h>)
  burnish_unity(${name})
  set(properties TIMEOUT 600 ENVIRONMENT OMP_WAIT_POLICY=passive)  # tests run side by side
  if(BURNISH_SANITIZE MATCHES thread)
    # The programs that a test starts inherit this too.
    list(APPEND properties ENVIRONMENT_MODIFICATION "TSAN_OPTIONS=set:\
suppressions=${PROJECT_SOURCE_DIR}/tests/tsan/uninstrumented.supp:second_deadlock_stack=1")
  endif()
  gtest_discover_tests(${name} DISCOVERY_TIMEOUT 60 PROPERTIES ${properties})
endfunction()
