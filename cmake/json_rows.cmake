# SPDX-License-Identifier: MIT
# Prints values of a JSON file for shell scripts, separated by tabs: one line for each entry of a list, which is the whole
# file or has a key, or one line for an object.
#
#   cmake -DJSON=FILE [-DLIST=KEY] -DKEYS=KEY,KEY.KEY,… -P json_rows.cmake
#
# A value that is empty or not there is printed as "-". Fails if the file does not hold JSON, or has no such list.
file(READ ${JSON} text)
string(JSON kind TYPE "${text}" ${LIST})
string(REPLACE "," ";" keys "${KEYS}")

# row(WHERE…): appends the line of the object at this path.
function(row)
  set(line "")
  foreach(key IN LISTS keys)
    string(REPLACE "." ";" path "${key}")
    string(JSON value ERROR_VARIABLE missing GET "${text}" ${ARGN} ${path})
    if(missing OR value STREQUAL "")
      set(value "-")
    endif()
    string(REGEX REPLACE "[\t\n]" " " value "${value}")
    string(APPEND line "\t${value}")
  endforeach()
  string(SUBSTRING "${line}" 1 -1 line)
  set(lines "${lines}${line}\n" PARENT_SCOPE)
endfunction()

set(lines "")
if(kind STREQUAL "ARRAY")
  string(JSON count LENGTH "${text}" ${LIST})
  if(count GREATER 0)
    math(EXPR last "${count} - 1")
    foreach(k RANGE ${last})
      row(${LIST} ${k})
    endforeach()
  endif()
else()
  row()
endif()
execute_process(COMMAND ${CMAKE_COMMAND} -E echo_append "${lines}")
