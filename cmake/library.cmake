# ballpit_library(FOLDER SOURCES… [LINK targets…] [PRECOMPILE headers…] [PRECOMPILED_BY target] [LIGHT]): the target of
# src/FOLDER, found by others as ballpit::FOLDER (of a folder in a folder, ballpit::OUTER_INNER). FOLDER is `cuda` for the
# folder beside src.
#
# Each target has an include root of its own, which holds a link to its folder and nothing else. So it sees the folders of
# the targets that it links and no others: an include that points upward does not compile.
#
# LIGHT is for code whose speed nobody notices: Release compiles it with -O1, in two thirds of the time of -O3.
# PRECOMPILE names large headers of other libraries that most of the sources include; PRECOMPILED_BY a target of the same
# options whose precompiled headers are used.
function(ballpit_library folder)
  cmake_parse_arguments(arg "LIGHT" "PRECOMPILED_BY" "SOURCES;LINK;PRECOMPILE" ${ARGN})
  string(REPLACE "/" "_" name ${folder})
  set(root ${PROJECT_BINARY_DIR}/include/${name})
  cmake_path(GET folder PARENT_PATH parent)
  file(MAKE_DIRECTORY ${root}/${parent})
  file(CREATE_LINK ${CMAKE_CURRENT_SOURCE_DIR} ${root}/${folder} SYMBOLIC)
  if(arg_SOURCES)
    add_library(ballpit_${name} STATIC ${arg_SOURCES})
    set(scope PUBLIC)
    target_link_libraries(ballpit_${name} PRIVATE ballpit_warnings)
  else()
    add_library(ballpit_${name} INTERFACE)
    set(scope INTERFACE)
  endif()
  target_include_directories(ballpit_${name} ${scope} ${root})
  target_link_libraries(ballpit_${name} ${scope} ballpit_floating_point ${arg_LINK})
  if(arg_LIGHT)
    ballpit_compile_lightly(ballpit_${name})
  endif()
  ballpit_precompile(ballpit_${name} ${arg_PRECOMPILE})
  if(arg_PRECOMPILED_BY)
    target_precompile_headers(ballpit_${name} REUSE_FROM ${arg_PRECOMPILED_BY})
  endif()
  add_library(ballpit::${name} ALIAS ballpit_${name})
endfunction()

function(ballpit_compile_lightly target)
  target_compile_options(${target} PRIVATE $<$<AND:$<CONFIG:Release>,$<COMPILE_LANGUAGE:CXX>>:-O1>)
endfunction()

function(ballpit_precompile target)
  foreach(header ${ARGN})
    target_precompile_headers(${target} PRIVATE "$<$<COMPILE_LANGUAGE:CXX>:${header}>")
  endforeach()
endfunction()
