# Fetches packages for main.mjs: cmake -D SOURCE= -D BUILD= -D NPM= -D ALL= -P build.cmake
# The small ones that the tests ask, or ALL. What is there already stays. The build goes on without
# those that cannot be fetched: main.mjs tells which are not there.
cmake_minimum_required(VERSION 3.25)
file(GLOB modules ${SOURCE}/*.mjs)
file(COPY ${modules} ${SOURCE}/package.json ${SOURCE}/package-lock.json ${SOURCE}/.npmrc
  DESTINATION ${BUILD})

function(fetch stamp)
  if(NOT ${SOURCE}/package-lock.json IS_NEWER_THAN ${stamp})
    return()
  endif()
  if(NPM)
    execute_process(
      COMMAND ${NPM} ci ${ARGN} --ignore-scripts --no-audit --no-fund --fetch-retries=1 --loglevel=error
      WORKING_DIRECTORY ${BUILD} RESULT_VARIABLE failed OUTPUT_VARIABLE told ERROR_VARIABLE told)
  else()
    set(failed "there is no npm")
  endif()
  if(failed)
    message("libraries from npm are left out: npm could not fetch them")
  else()
    file(TOUCH ${stamp})
  endif()
endfunction()

if(ALL OR EXISTS ${BUILD}/all_fetched)
  fetch(${BUILD}/all_fetched)
else()
  fetch(${BUILD}/fetched --omit=optional)
endif()
