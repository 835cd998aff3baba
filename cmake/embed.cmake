# ballpit_embed(TARGET NAME FILES…): compiles text files into TARGET.
#
# Generates NAME.h in namespace ballpit with `const std::vector<EmbeddedFile>& NAME()`: file names (without folders, in
# the order given) and contents. The program then needs no files at run time, wherever it is installed.
function(ballpit_embed target name)
  string(REPLACE ";" "|" files "${ARGN}")
  ballpit_embed_by(embed_files ${target} ${name} "-DFILES=${files}" ${ARGN})
endfunction()

# ballpit_embed_bytes(TARGET NAME FILE): compiles any file into TARGET; NAME.h declares its bytes, NAME() and NAME_size().
function(ballpit_embed_bytes target name file)
  ballpit_embed_by(embed_bytes ${target} ${name} -DFILE=${file} ${file})
endfunction()

# By a script of this folder. The generated files are a target of their own, which links nothing: generated in TARGET, they
# would wait until all libraries that it links are there, and all sources of TARGET with them.
function(ballpit_embed_by script target name argument)
  set(header ${CMAKE_CURRENT_BINARY_DIR}/embedded/${name}.h)
  set(source ${CMAKE_CURRENT_BINARY_DIR}/embedded/${name}.cpp)
  set(script ${PROJECT_SOURCE_DIR}/cmake/${script}.cmake)
  add_custom_command(
    OUTPUT ${header} ${source}
    COMMAND ${CMAKE_COMMAND} -DNAME=${name} -DHEADER=${header} -DSOURCE=${source} ${argument} -P ${script}
    DEPENDS ${ARGN} ${script}
    VERBATIM)
  add_library(ballpit_${name} STATIC ${header} ${source})
  target_include_directories(ballpit_${name}
    PUBLIC ${CMAKE_CURRENT_BINARY_DIR}/embedded PRIVATE ${PROJECT_BINARY_DIR}/include/core)
  target_link_libraries(${target} PRIVATE ballpit_${name})
endfunction()
