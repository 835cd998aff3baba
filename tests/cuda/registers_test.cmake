# Registers and local memory of every kernel, as ptxas reports them for the oldest architecture and for one that holds 2048
# threads in a multiprocessor. Compiles worlds_cuda_float.cu alone, without the host's part: half a minute.
#
#     cmake -DNVCC=… -DSOURCE=…/cuda/worlds_cuda_float.cu "-DFLAGS=-I…|--fmad=false" -DOUT=… -P registers_test.cmake
#
# A multiprocessor has 65 536 registers. Where it holds 1024 threads (7.5) each may use 64 of them, where it holds 2048
# (8.0, 9.0, 10.0) 32, or fewer threads run at once to hide memory's latency: 75 % at 40, 62 % at 48, 50 % at 56.
# So no kernel may use more than 32 but those listed here, no more than their number; and none may use local memory but
# those in `spilling`.
set(allowed
  # Position, radius, counts, and the walk through five rows, with the nearest image in periodic domains and the reach into
  # finer size classes. Held to 32, the first spills 520 bytes a thread.
  "CountInRows.*SortedGrid" 56
  "FillRows.*SortedGrid" 48
  # The same where candidates are listed for a report.
  "(Count|Fill)Contacts.*SortedGrid" 48
  "(Count|Fill)Contacts.*LinkedCell" 40
  # The same walk without tests, for reports alone.
  "MeasureRanges.*SortedGrid" 40
  # The same with up to 27 lists, found by three nested loops. Held to 32: 100 bytes.
  "CountInRows.*LinkedCell" 56
  "FillRows.*LinkedCell" 56
  # One range, and in periodic domains a search for another. Held to 32: 56 bytes.
  "CountInRows.*SortAndSweep" 48
  "FillRows.*SortAndSweep" 48
  # One range. Held to 32: 28 bytes; without periodic domains it would do with 32.
  "CountInRows.*BruteForce" 48
  "FillRows.*BruteForce" 40
  "CountInRows.*ListedCandidates" 40
  "FillRows.*ListedCandidates" 40
  # The slides' kernels as they are, not tuned: the lists of nine or 27 cells; the walk along the list.
  "Collide.*LinkedCell" 48
  "Collide.*SortAndSweep" 40
  # Two loops over a body's contacts, which the compiler unrolls by four, so that four gathers are under way at once; and the
  # sums of contacts and walls.
  "ResolveVelocity" 48
  "CorrectPosition" 40
  "DriftCorrected" 40
  # Two short loops, one of which measures.
  "MeasureRow" 40
  # Six walls, of which each may be met, on the way as well; where contacts are swept, also the time of each.
  "Accelerate" 48
  "FindFirst" 40
  # The same, and the bounces between two walls, without a spill.
  "SweptDrift" 64
  # The hits on the same way, for a tally alone.
  "CountWallHits" 48
  # Up to four obstacles at once, and the equations for how much a sphere presses on each.
  "MirrorVelocity" 96
  # All phases of a solution by colours: what walls need and what contacts need, in one kernel.
  "SolveByColour.*(MoveOutOfWalls|SolveWalls)" 56
  "SolveByColour.*ReboundFromWalls" 48
  # The four strongest occluders so far with their shares, and the sums of the others: once for a picture, not in a step.
  "FindOccluders" 64
  # Sums in double precision: of three axes for the sweep; for reports and the guard, energy, momentum and the largest
  # overlap; for a tally, collisions.
  "ReduceBlock.*AxisSums" 48
  "ReduceBlock.*EnergyAndMomentum" 48
  "ReduceBlock.*Collisions" 48
  "ReduceBlock.*Overlap" 48
  "ReduceBlock.*LeastEnergy" 48
  "ReduceBlock.*Energy" 40)

# A sphere's obstacles are few, but how many is known only at run time: they are an array. Spheres in free flight do not
# touch it. The response is there to be seen, not for speed.
set(spilling "MirrorVelocity")

string(REPLACE "|" ";" flags "${FLAGS}")

function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "${ARGN}: ${status}\n${output}")
  endif()
  set(output "${output}" PARENT_SCOPE)
endfunction()

# The number of registers that a kernel may use, by its mangled name.
function(allowed_registers name result)
  set(rest ${allowed})
  while(rest)
    list(POP_FRONT rest pattern number)
    if(name MATCHES "[0-9]${pattern}")
      set(${result} ${number} PARENT_SCOPE)
      return()
    endif()
  endwhile()
  set(${result} 32 PARENT_SCOPE)
endfunction()

# Checks all kernels for an architecture on which every kernel may use `common` registers, or those allowed.
function(check architecture common)
  run(${NVCC} -cubin -arch=sm_${architecture} -Xptxas=-v ${OUT}.ptx -o ${OUT}.cubin)
  string(REGEX MATCHALL "Function properties for [^\n]*run_[a-z_]*kernel[^\n]*\n[^\n]*\n[^\n]*Used [0-9]+ registers" kernels "${output}")
  list(LENGTH kernels count)
  if(count LESS 60)
    message(FATAL_ERROR "sm_${architecture}: found ${count} kernels in\n${output}")
  endif()
  foreach(kernel IN LISTS kernels)
    string(REGEX REPLACE "Function properties for ([^\n]*)\n.*" "\\1" name "${kernel}")
    string(REGEX REPLACE ".*\n *([0-9]+) bytes stack frame.*" "\\1" stack "${kernel}")
    string(REGEX REPLACE ".*Used ([0-9]+) registers" "\\1" registers "${kernel}")
    allowed_registers("${name}" limit)
    if(limit LESS common)
      set(limit ${common})
    endif()
    if(registers GREATER limit)
      message(SEND_ERROR "sm_${architecture}: ${registers} registers, allowed ${limit}: ${name}")
    endif()
    if(NOT stack EQUAL 0 AND NOT name MATCHES "[0-9](${spilling})")
      message(SEND_ERROR "sm_${architecture}: ${stack} bytes of local memory: ${name}")
    endif()
    message(STATUS "sm_${architecture}: ${registers} registers: ${name}")
  endforeach()
endfunction()

run(${NVCC} ${flags} -ptx -arch=compute_75 ${SOURCE} -o ${OUT}.ptx)
check(75 64)
check(90 32)
