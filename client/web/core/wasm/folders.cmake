# The client's folders, without what only a program with files, threads or a window needs. What
# stands in its place lies in client/web/core/host and client/web/core/transport.

function(core_options name)
  target_include_directories(${name} PRIVATE ${root})
  # threadless: <mutex> with the locks that the library of a browser lacks.
  target_include_directories(${name} SYSTEM PRIVATE ${core}/wasm/threadless ${core}/gl ${core}/transport ${EIGEN})
  target_link_libraries(${name} PRIVATE proto zstd)
  target_compile_definitions(${name} PRIVATE NDEBUG EIGEN_DONT_PARALLELIZE XXH_INLINE_ALL
    JSON_NOEXCEPTION JSON_NO_IO)
  target_compile_options(${name} PRIVATE ${BURNISH_WEB_FLAGS} -fno-math-errno -ffp-contract=off
    -Wall -Wextra -Wshadow -Wnon-virtual-dtor -Wno-missing-field-initializers -Wno-unknown-pragmas)
  if(BURNISH_WERROR)
    target_compile_options(${name} PRIVATE -Werror)
  endif()
endfunction()

# core_folder(FOLDER [SPEED level] [ONLY name...] [EXCEPT name...]): the folder's sources. SPEED: what frames wait for
# is compiled at -O2, what pages wait for at -Os, all else for size.
function(core_folder folder)
  cmake_parse_arguments(arg "" "SPEED" "EXCEPT;ONLY" ${ARGN})
  file(GLOB sources CONFIGURE_DEPENDS ${root}/${folder}/*.cpp)
  foreach(name ${arg_EXCEPT} ${arg_ONLY})
    if(NOT EXISTS ${root}/${folder}/${name}.cpp)
      message(FATAL_ERROR "there is no ${folder}/${name}.cpp")
    endif()
    list(REMOVE_ITEM sources ${root}/${folder}/${name}.cpp)
  endforeach()
  if(arg_ONLY)
    list(TRANSFORM arg_ONLY PREPEND ${root}/${folder}/ OUTPUT_VARIABLE sources)
    list(TRANSFORM sources APPEND .cpp)
  endif()
  string(REPLACE / _ name ${folder})
  add_library(${name} OBJECT ${sources})
  core_options(${name})
  # As in the native full build: many sources of a folder as one.
  if(arg_SPEED)
    target_compile_options(${name} PRIVATE ${arg_SPEED})
  else()
    set_target_properties(${name} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 16)
  endif()
  set_property(GLOBAL APPEND PROPERTY core_folders ${name})
endfunction()

core_folder(common/base ONLY base64 check fixed_text status text text_lines)
core_folder(common/mesh ONLY export_formats mesh_format srgb triangle_mesh
  statistics/statistics statistics/thin_walls textures/texel_change)
core_folder(common/mesh/rewrite ONLY left_out/left_out_text)
core_folder(common/grid SPEED -Os)
core_folder(common/evaluation SPEED -Os)
core_folder(common/edit)
core_folder(common/packing SPEED -O2)
core_folder(common/pages SPEED -Os EXCEPT page_encoder page_file page_writer walk_planner)
core_folder(common/page_frames SPEED -O2 EXCEPT page_frame_encoder page_sample sent_page_frames)
core_folder(common/sheets ONLY chart chart_codec sheet_block_codec sheet_codec sheet_head_codec sheet_layout webp_header)
core_folder(common/transfer EXCEPT chunk_crc32 content_hash)
core_folder(common/service)
core_folder(common/measure)
core_folder(common/wire)
core_folder(client/scene EXCEPT png_reader png_writer raw_pages thinned_triangles)
core_folder(client/pages)
core_folder(client/live)
core_folder(client/tools EXCEPT own_presets_file user_folders)
core_folder(client/sheets EXCEPT texture_decoder)
core_folder(client/surface EXCEPT page_desk_thread texture_desk_thread)
core_folder(client/report ONLY about_text depth_text deviation_json entry_text length_ticks moves_text processing_record
  record_json record_page section_file time_text)
file(STRINGS ${root}/CMakeLists.txt project REGEX "^project\\(burnish VERSION")
string(REGEX MATCH "[0-9.]+" BURNISH_VERSION "${project}")
target_compile_definitions(client_report PRIVATE BURNISH_VERSION="${BURNISH_VERSION}")
core_folder(client/connection ONLY call_status connection edit_calls export_call
  history_calls import_call measure_calls page_calls page_value_calls rename_calls sheet_calls)
core_folder(client/model/tasks EXCEPT async_task tasks)
core_folder(client/model/input)
core_folder(client/model/settings EXCEPT connection_form lighting_toml preferences)
core_folder(client/model/documents EXCEPT recorder_file)
core_folder(client/model/view EXCEPT raw_scan_file view_state)
core_folder(client/model/workspace EXCEPT leaving letters session_picture_files workspace_raw_file)
core_folder(client/panels)
core_folder(client/script EXCEPT lone_script)
core_folder(client/web/core)
core_folder(client/web/core/transport)
core_folder(client/web/core/host)
core_folder(client/web/core/libraries)
core_folder(client/web/core/messages)
# They run once a scan, or once a block of its directory.
foreach(name grid/corner_bricks grid/depth_plan pages/block_codec pages/directory pages/head_codec pages/page_header)
  set_source_files_properties(${root}/common/${name}.cpp PROPERTIES COMPILE_OPTIONS -Oz)
endforeach()
get_property(shared GLOBAL PROPERTY core_folders)

# core_program(NAME FOLDER...): a core that draws with these folders.
function(core_program name)
  list(TRANSFORM shared REPLACE "(.+)" "$<TARGET_OBJECTS:\\1>" OUTPUT_VARIABLE objects)
  string(REPLACE / _ drawing "${ARGN}")
  list(TRANSFORM drawing REPLACE "(.+)" "$<TARGET_OBJECTS:\\1>")
  add_executable(${name} ${objects} ${drawing} $<TARGET_OBJECTS:proto> $<TARGET_OBJECTS:zstd>)
  set_target_properties(${name} PROPERTIES SUFFIX .wasm LINKER_LANGUAGE CXX)
  target_link_options(${name} PRIVATE ${BURNISH_WEB_FLAGS} -mexec-model=reactor
    -Wl,--gc-sections,--strip-all,--export=__stack_pointer,--stack-first,-z,stack-size=1048576
    -Wl,-mllvm,-enable-merge-functions)  # templates of many types are often the same code
endfunction()

core_folder(client/gl EXCEPT context_egl)
core_folder(client/web/core/card)
core_program(core client/gl client/web/core/card)
# Every browser with JSPI has registers of four numbers.
core_folder(client/raster SPEED -O2 EXCEPT work_crew)
target_compile_options(client_raster PRIVATE -msimd128)
set_source_files_properties(${root}/client/raster/near_clip.cpp ${root}/client/raster/raster_page_renderer.cpp
  ${root}/client/raster/shaded_scene.cpp PROPERTIES COMPILE_OPTIONS -Oz)  # run once a picture, or seldom
core_folder(client/web/core/raster)
core_program(core_raster client/raster client/web/core/raster)

# For tests under Node: the code of the core that reads what others have written, without a page.
file(GLOB checks ${root}/tests/client/web/core/wasm/checks.cpp ${root}/tests/client/web/core/wasm/exports.cpp)
list(FILTER shared EXCLUDE REGEX "^client_(connection|model_[a-z]+|panels|script|web_core(_host|_transport)?)$")
list(TRANSFORM shared REPLACE "(.+)" "$<TARGET_OBJECTS:\\1>" OUTPUT_VARIABLE objects)
add_executable(checks EXCLUDE_FROM_ALL ${checks} ${objects})
set_target_properties(checks PROPERTIES SUFFIX .wasm)
core_options(checks)
target_link_options(checks PRIVATE ${BURNISH_WEB_FLAGS} -mexec-model=reactor
  -Wl,--gc-sections,--strip-all,--stack-first,-z,stack-size=1048576)
