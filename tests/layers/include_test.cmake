# What the preprocessor finds with the include directories of one folder's target:
#
#     cmake -DCOMPILER=g++ -DINCLUDES=DIR;… -DFOLDER=response -DSOURCE=src/response -DABOVE=narrow_phase/collider.h
#           -P include_test.cmake
#
# All headers of the folder must preprocess, so none of them includes a folder above it. This matters because other
# targets, which see more, compile most headers. A file that includes ABOVE must fail: the header is not found. "-" is none.
set(ENV{LC_ALL} C)
list(TRANSFORM INCLUDES PREPEND -I)

function(preprocess text)
  file(WRITE ${FOLDER}.cpp "${text}")
  execute_process(COMMAND ${COMPILER} -std=c++20 ${INCLUDES} -M ${FOLDER}.cpp
    RESULT_VARIABLE status OUTPUT_QUIET ERROR_VARIABLE errors)
  set(status ${status} PARENT_SCOPE)
  set(errors "${errors}" PARENT_SCOPE)
endfunction()

file(GLOB_RECURSE headers ${SOURCE}/*.h)
if(NOT headers)
  message(FATAL_ERROR "no headers in ${SOURCE}")
endif()
list(TRANSFORM headers REPLACE "(.+)" "#include \"\\1\"\n")
string(CONCAT includes ${headers})
preprocess("${includes}")
if(NOT status EQUAL 0)
  message(FATAL_ERROR "a header of ${FOLDER} includes what ${FOLDER} does not see:\n${errors}")
endif()

if(NOT ABOVE STREQUAL "-")
  preprocess("#include \"${ABOVE}\"\n")
  if(status EQUAL 0 OR NOT errors MATCHES "${ABOVE}('|:)[^\n]*(No such file|file not found)")
    message(FATAL_ERROR "${FOLDER} must not find ${ABOVE}, but the compiler said: ${status}\n${errors}")
  endif()
endif()
