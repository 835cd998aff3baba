# The same bits everywhere: no fused multiply-add unless the source asks for one, no reassociation. And no vectorising
# of neighbouring statements by GCC: 12.2 then drops the rounding in double(float(x)) (tests/core/math_test.cpp shows it).
add_library(ballpit_floating_point INTERFACE)
target_compile_options(ballpit_floating_point INTERFACE
  $<$<COMPILE_LANGUAGE:CXX>:-ffp-contract=off -fno-fast-math>
  $<$<COMPILE_LANG_AND_ID:CXX,GNU>:-fno-tree-slp-vectorize>
  $<$<COMPILE_LANGUAGE:CUDA>:--fmad=false -Xcompiler=-ffp-contract=off,-fno-tree-slp-vectorize>)
