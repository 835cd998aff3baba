# BALLPIT_CUDA: AUTO builds the CUDA backend where nvcc is found, ON requires it, OFF builds the stub.
# CMAKE_CUDA_ARCHITECTURES and CMAKE_CUDA_RUNTIME_LIBRARY from the command line are honoured.
set(BALLPIT_CUDA AUTO CACHE STRING "Build the CUDA backend: AUTO, ON or OFF")
set_property(CACHE BALLPIT_CUDA PROPERTY STRINGS AUTO ON OFF)

set(BALLPIT_HAVE_CUDA OFF)
if(NOT BALLPIT_CUDA STREQUAL "OFF")
  include(CheckLanguage)
  if(NOT DEFINED CMAKE_CUDA_ARCHITECTURES)
    # One architecture, the oldest that CUDA 13 compiles for: newer devices compile its PTX when they load it.
    set(CMAKE_CUDA_ARCHITECTURES 75)
  endif()
  check_language(CUDA)
  if(CMAKE_CUDA_COMPILER)
    enable_language(CUDA)
    find_package(CUDAToolkit REQUIRED)
    if(NOT DEFINED CMAKE_CUDA20_STANDARD_COMPILE_OPTION)
      # nvcc has C++20 since 12.0, but the CMake of Debian 12 does not know how to ask for it.
      set(CMAKE_CUDA20_STANDARD_COMPILE_OPTION "-std=c++20")
      set(CMAKE_CUDA20_EXTENSION_COMPILE_OPTION "-std=c++20")
    endif()
    set(CMAKE_CUDA_STANDARD 20)
    set(CMAKE_CUDA_STANDARD_REQUIRED ON)
    # nvcc's -O is for the part that runs on the CPU, which submits launches; it optimises kernels unless told otherwise.
    string(REPLACE "-O3" "-O1" CMAKE_CUDA_FLAGS_RELEASE "${CMAKE_CUDA_FLAGS_RELEASE}")
    set(BALLPIT_HAVE_CUDA ON)
  elseif(BALLPIT_CUDA STREQUAL "ON")
    message(FATAL_ERROR "BALLPIT_CUDA=ON, but no nvcc was found. Install the CUDA Toolkit or use BALLPIT_CUDA=AUTO.")
  endif()
endif()
message(STATUS "Ballpit: CUDA backend ${BALLPIT_HAVE_CUDA}")
