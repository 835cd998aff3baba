# The same bits everywhere: no fused multiply-add unless the source asks for one, no reassociation. GCC makes vector
# instructions only of loops that ask for them (#pragma omp simd): for a body's few contacts they cost more than they
# gain, and of neighbouring statements 12.2 makes some that drop the rounding in double(float(x))
# (tests/core/math_test.cpp shows it).
add_library(ballpit_floating_point INTERFACE)
target_compile_options(ballpit_floating_point INTERFACE
  $<$<COMPILE_LANGUAGE:CXX>:-ffp-contract=off -fno-fast-math>
  $<$<COMPILE_LANG_AND_ID:CXX,GNU,Clang>:-fopenmp-simd>
  $<$<COMPILE_LANG_AND_ID:CXX,GNU>:-fno-tree-vectorize>
  $<$<COMPILE_LANGUAGE:CUDA>:--fmad=false -Xcompiler=-ffp-contract=off,-fno-tree-vectorize>)
