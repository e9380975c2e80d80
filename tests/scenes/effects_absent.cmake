# cmake -D VALGRIND=valgrind -D ALL=program -D NONE=program -D TO=folder -P effects_absent.cmake
# Fails unless a scene that calls for no effect costs what it does in a program that was built without
# any, within 1 %, and runs nothing of them, while a scene in a light runs the shadows.
cmake_minimum_required(VERSION 3.25)

# Counts what Tracer::rows and all that it calls do: instructions, and the names of the functions.
function(profile program scene name)
  set(file ${TO}/${name}.callgrind)
  file(MAKE_DIRECTORY ${TO})
  execute_process(COMMAND ${VALGRIND} --tool=callgrind --callgrind-out-file=${file}
    "--toggle-collect=rayaudit::Tracer::rows(*" ${program} ${scene}
    OUTPUT_VARIABLE sum ERROR_QUIET COMMAND_ERROR_IS_FATAL ANY)
  file(STRINGS ${file} counted REGEX "^(summary|totals):")
  list(GET counted 0 counted)
  string(REGEX REPLACE "^[a-z]+: *([0-9]+).*" "\\1" counted "${counted}")
  file(STRINGS ${file} functions REGEX "^c?fn=\\([0-9]+\\) ")
  set(${name}_counted ${counted} PARENT_SCOPE)
  set(${name}_functions "${functions}" PARENT_SCOPE)
  set(${name}_sum ${sum} PARENT_SCOPE)
endfunction()

profile(${ALL} dark all)
profile(${NONE} dark none)
profile(${ALL} light lit)
message(STATUS "instructions: ${all_counted}; built without effects: ${none_counted}; in a light: ${lit_counted}")

if(NOT all_sum STREQUAL none_sum)
  message(FATAL_ERROR "the pictures differ: ${all_sum} and ${none_sum}")
endif()
if(none_counted LESS 1000000)
  message(FATAL_ERROR "${none_counted} instructions are no picture")
endif()
math(EXPR difference "${all_counted} - ${none_counted}")
string(REPLACE "-" "" difference "${difference}")
math(EXPR hundredfold "100 * ${difference}")
if(hundredfold GREATER none_counted)
  message(FATAL_ERROR "${all_counted} instructions are not ${none_counted}, within 1 %")
endif()
if(all_functions MATCHES "queue_(shadows|reflection|refraction)|follow_shadows|follow_bounce")
  message(FATAL_ERROR "a scene that calls for no effect runs ${CMAKE_MATCH_0}")
endif()
foreach(function queue_shadows follow_shadows)
  if(NOT lit_functions MATCHES ${function})
    message(FATAL_ERROR "a scene in a light does not run ${function}: its name tells nothing")
  endif()
endforeach()
if(lit_functions MATCHES "queue_(reflection|refraction)|follow_bounce")
  message(FATAL_ERROR "a scene in a light runs ${CMAKE_MATCH_0}")
endif()
