# ballpit_embed(TARGET NAME FILES…): compiles text files into TARGET.
#
# Generates NAME.h in namespace ballpit with `const std::vector<EmbeddedFile>& NAME()`: file names (without folders, in
# the order given) and contents. The program then needs no files at run time, wherever it is installed.
function(ballpit_embed target name)
  set(header ${CMAKE_CURRENT_BINARY_DIR}/embedded/${name}.h)
  set(source ${CMAKE_CURRENT_BINARY_DIR}/embedded/${name}.cpp)
  string(REPLACE ";" "|" files "${ARGN}")
  add_custom_command(
    OUTPUT ${header} ${source}
    COMMAND ${CMAKE_COMMAND} -DNAME=${name} -DHEADER=${header} -DSOURCE=${source} "-DFILES=${files}"
            -P ${PROJECT_SOURCE_DIR}/cmake/embed_files.cmake
    DEPENDS ${ARGN} ${PROJECT_SOURCE_DIR}/cmake/embed_files.cmake
    VERBATIM)
  target_sources(${target} PRIVATE ${header} ${source})
  set_source_files_properties(${source} PROPERTIES SKIP_PRECOMPILE_HEADERS ON SKIP_UNITY_BUILD_INCLUSION ON)
  target_include_directories(${target} PRIVATE ${CMAKE_CURRENT_BINARY_DIR}/embedded)
endfunction()

# ballpit_embed_bytes(TARGET NAME FILE): compiles any file into TARGET; NAME.h declares its bytes, NAME() and NAME_size().
function(ballpit_embed_bytes target name file)
  set(header ${CMAKE_CURRENT_BINARY_DIR}/embedded/${name}.h)
  set(source ${CMAKE_CURRENT_BINARY_DIR}/embedded/${name}.cpp)
  add_custom_command(
    OUTPUT ${header} ${source}
    COMMAND ${CMAKE_COMMAND} -DNAME=${name} -DHEADER=${header} -DSOURCE=${source} -DFILE=${file}
            -P ${PROJECT_SOURCE_DIR}/cmake/embed_bytes.cmake
    DEPENDS ${file} ${PROJECT_SOURCE_DIR}/cmake/embed_bytes.cmake
    VERBATIM)
  target_sources(${target} PRIVATE ${header} ${source})
  set_source_files_properties(${source} PROPERTIES SKIP_PRECOMPILE_HEADERS ON SKIP_UNITY_BUILD_INCLUSION ON)
  target_include_directories(${target} PRIVATE ${CMAKE_CURRENT_BINARY_DIR}/embedded)
endfunction()
