# BALLPIT_SANITIZE: a list for -fsanitize, as the presets asan and tsan set it.
set(BALLPIT_SANITIZE "" CACHE STRING "Sanitizers, comma separated: address,undefined or thread")
if(BALLPIT_SANITIZE)
  add_compile_options(-fsanitize=${BALLPIT_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  add_compile_options(-Wno-maybe-uninitialized)  # GCC 12 takes the standard library's <regex> for that under sanitizers
  add_link_options(-fsanitize=${BALLPIT_SANITIZE})
endif()
