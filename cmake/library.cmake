# ballpit_library(NAME SOURCES… [LINK targets…] [PRECOMPILE headers…] [LIGHT]): one target per folder, found by others as
# ballpit::NAME.
#
# LIGHT is for code whose speed nobody notices: Release compiles it with -O1, in two thirds of the time of -O3.
# PRECOMPILE names large headers of other libraries that most of the sources include.
function(ballpit_library name)
  cmake_parse_arguments(arg "LIGHT" "" "SOURCES;LINK;PRECOMPILE" ${ARGN})
  if(arg_SOURCES)
    add_library(ballpit_${name} STATIC ${arg_SOURCES})
    set(scope PUBLIC)
    target_link_libraries(ballpit_${name} PRIVATE ballpit_warnings)
  else()
    add_library(ballpit_${name} INTERFACE)
    set(scope INTERFACE)
  endif()
  target_include_directories(ballpit_${name} ${scope} ${PROJECT_SOURCE_DIR}/src)
  target_link_libraries(ballpit_${name} ${scope} ballpit_floating_point ${arg_LINK})
  if(arg_LIGHT)
    ballpit_compile_lightly(ballpit_${name})
  endif()
  ballpit_precompile(ballpit_${name} ${arg_PRECOMPILE})
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
