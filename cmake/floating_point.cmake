# The same bits everywhere: no fused multiply-add unless the source asks for one, no reassociation.
add_library(ballpit_floating_point INTERFACE)
target_compile_options(ballpit_floating_point INTERFACE
  $<$<COMPILE_LANGUAGE:CXX>:-ffp-contract=off -fno-fast-math>
  $<$<COMPILE_LANGUAGE:CUDA>:--fmad=false -Xcompiler=-ffp-contract=off>)
