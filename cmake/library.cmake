# Other libraries' headers are 99 % of the lines that the compiler reads for a source. These are precompiled for all.
set(BALLPIT_COMMON_HEADERS
  <algorithm> <array> <cmath> <functional> <memory> <optional> <span> <string> <vector> <fmt/format.h> <glm/glm.hpp>)

# ballpit_library(FOLDER SOURCES… [LINK targets…] [PRECOMPILE headers…] [LIGHT] [APART]): the target of src/FOLDER, found by
# others as ballpit::FOLDER (of a folder in a folder, ballpit::OUTER_INNER). FOLDER is `cuda` for the folder beside src.
#
# Each target has an include root of its own, which holds a link to its folder and nothing else. So it sees the folders of
# the targets that it links and no others: an include that points upward does not compile.
#
# LIGHT is for code whose speed nobody notices: Release compiles it with -O1, in two thirds of the time of -O3.
# PRECOMPILE names further large headers that most of the sources include. Where CMAKE_UNITY_BUILD is on, eight sources
# are compiled as one; APART is for those that take long, as kernels do, or define the same names.
function(ballpit_library folder)
  cmake_parse_arguments(arg "LIGHT;APART" "" "SOURCES;LINK;PRECOMPILE" ${ARGN})
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
  if(arg_APART)
    set_target_properties(ballpit_${name} PROPERTIES UNITY_BUILD OFF)
  endif()
  if(arg_LIGHT)
    ballpit_compile_lightly(ballpit_${name})
    ballpit_precompile(ballpit_${name} light ${arg_PRECOMPILE})
  elseif(arg_SOURCES)
    ballpit_precompile(ballpit_${name} full ${arg_PRECOMPILE})
  endif()
  add_library(ballpit::${name} ALIAS ballpit_${name})
endfunction()

function(ballpit_compile_lightly target)
  target_compile_options(${target} PRIVATE $<$<AND:$<CONFIG:Release>,$<COMPILE_LANGUAGE:CXX>>:-O1>)
endfunction()

# ballpit_precompile(TARGET OPTIONS [HEADERS…]): precompiles the common headers and HEADERS. Targets with the same compiler
# options, for which OPTIONS is a name, and the same HEADERS use what the first of them has compiled.
function(ballpit_precompile target options)
  string(MD5 key "${options} ${ARGN}")
  get_property(first GLOBAL PROPERTY ballpit_precompiled_${key})
  if(first)
    target_precompile_headers(${target} REUSE_FROM ${first})
    return()
  endif()
  set_property(GLOBAL PROPERTY ballpit_precompiled_${key} ${target})
  foreach(header ${BALLPIT_COMMON_HEADERS} ${ARGN})
    target_precompile_headers(${target} PRIVATE "$<$<COMPILE_LANGUAGE:CXX>:${header}>")
  endforeach()
endfunction()
