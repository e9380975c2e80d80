# Makes the page that reports are put into: cmake -D SOURCE= -D BUILD= -D NPM= -D NODE= -P build.cmake
# Leaves an empty file, and the build goes on, where there is no npm or it cannot fetch its packages.
cmake_minimum_required(VERSION 3.25)
set(page ${BUILD}/page.html)
set(stamp ${BUILD}/node_modules/.package-lock.json)

function(go_without why)
  message("html reports are left out: ${why}")
  file(WRITE ${page} "")
endfunction()

if(NOT NPM OR NOT NODE)
  go_without("there is no npm")
  return()
endif()

if(${SOURCE}/package-lock.json IS_NEWER_THAN ${stamp})
  file(COPY ${SOURCE}/package.json ${SOURCE}/package-lock.json ${SOURCE}/.npmrc DESTINATION ${BUILD})
  execute_process(
    COMMAND ${NPM} ci --ignore-scripts --no-audit --no-fund --fetch-retries=1 --loglevel=error
    WORKING_DIRECTORY ${BUILD} RESULT_VARIABLE failed OUTPUT_VARIABLE told ERROR_VARIABLE told)
  if(failed)
    file(REMOVE_RECURSE ${BUILD}/node_modules)
    go_without("npm could not fetch vega, vega-lite and vega-embed")
    return()
  endif()
  file(TOUCH ${stamp})
endif()
execute_process(COMMAND ${NODE} ${SOURCE}/assemble.mjs ${BUILD}/node_modules ${page}
  COMMAND_ERROR_IS_FATAL ANY)
