# cmake -D NM=nm -D LIBRARY=librayaudit.so -P symbols.cmake
# Fails where the library shows a symbol that is no function of oracle.h, or hides one of those.
cmake_minimum_required(VERSION 3.25)
execute_process(COMMAND ${NM} -D --defined-only --format=posix ${LIBRARY}
  OUTPUT_VARIABLE listed COMMAND_ERROR_IS_FATAL ANY)
string(REGEX MATCHALL "(^|\n)[^ ]+" shown "${listed}")
list(TRANSFORM shown STRIP)
file(READ ${CMAKE_CURRENT_LIST_DIR}/../../src/rayaudit/oracle.h header)
string(REGEX REPLACE "///[^\n]*" "" header "${header}")
string(REGEX MATCHALL "rayaudit_[a-z_]+\\(" declared "${header}")
list(TRANSFORM declared REPLACE "\\(" "")
list(REMOVE_DUPLICATES declared)
list(SORT shown)
list(SORT declared)
if(NOT shown STREQUAL declared)
  message(FATAL_ERROR "shown:\n${shown}\ndeclared:\n${declared}")
endif()
