# Warnings for our own C++ targets; errors where BALLPIT_WERROR is on (it is in continuous integration).
option(BALLPIT_WERROR "Treat warnings as errors" $ENV{CI})

add_library(ballpit_warnings INTERFACE)
target_compile_options(ballpit_warnings INTERFACE
  $<$<COMPILE_LANGUAGE:CXX>:-Wall -Wextra -Wshadow -Wnon-virtual-dtor -Woverloaded-virtual -Wcast-align>
  $<$<AND:$<COMPILE_LANGUAGE:CXX>,$<BOOL:${BALLPIT_WERROR}>>:-Werror>
  $<$<AND:$<COMPILE_LANGUAGE:CUDA>,$<BOOL:${BALLPIT_WERROR}>>:-Werror=all-warnings>)
