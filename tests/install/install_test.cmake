# What is installed serves others: cmake -D BUILD=tree -D TO=folder -D AS=files|package -P this
# Installs the built tree, builds the project outside/ against it and looks at what it says.
cmake_minimum_required(VERSION 3.25)
set(here ${CMAKE_CURRENT_LIST_DIR})

# Runs a command; its exit code and all of its output, white space made single.
function(run code text)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE ended OUTPUT_VARIABLE said ERROR_VARIABLE said)
  string(REGEX REPLACE "[ \n\r\t]+" " " said "${said}")
  set(${code} "${ended}" PARENT_SCOPE)
  set(${text} "${said}" PARENT_SCOPE)
endfunction()

function(run_or_fail)
  run(code text ${ARGN})
  if(NOT code EQUAL 0)
    list(JOIN ARGN " " command)
    message(FATAL_ERROR "${command}\nended with ${code}:\n${text}")
  endif()
endfunction()

# Fails unless the text holds the words.
function(require_words what text words)
  string(FIND "${text}" "${words}" place)
  if(place EQUAL -1)
    message(SEND_ERROR "${what}: expected\n${words}\nin\n${text}")
  endif()
endfunction()

file(REMOVE_RECURSE ${TO})
file(MAKE_DIRECTORY ${TO})
if(AS STREQUAL "package")
  find_program(dpkg dpkg-deb)
  if(NOT dpkg)
    message("skipped: there is no dpkg-deb to unpack a Debian package")
    return()
  endif()
  run_or_fail(${CMAKE_CPACK_COMMAND} -G DEB --config ${BUILD}/CPackConfig.cmake -B ${TO}/made)
  file(GLOB package ${TO}/made/*.deb)
  run_or_fail(${dpkg} -x ${package} ${TO})
  run(code text ${dpkg} -f ${package} Depends)
  foreach(needed libc6 libfmt9 libgcc-s1 libgmp10 libstdc++6 libtbb12)
    require_words("the package depends" "${text}" ${needed})
  endforeach()
else()
  run_or_fail(${CMAKE_COMMAND} --install ${BUILD} --prefix ${TO}/usr)
endif()

set(configure ${CMAKE_COMMAND} -G ${GENERATOR} -D CMAKE_CXX_COMPILER=${CXX}
  -D CMAKE_PREFIX_PATH=${TO}/usr)
if(LAUNCHER)
  list(APPEND configure -D CMAKE_C_COMPILER_LAUNCHER=${LAUNCHER}
    -D CMAKE_CXX_COMPILER_LAUNCHER=${LAUNCHER})
endif()
run_or_fail(${configure} -S ${here}/outside -B ${TO}/outside)
run_or_fail(${CMAKE_COMMAND} --build ${TO}/outside)

file(READ ${TO}/outside/compile_commands.json commands)
if(commands MATCHES "CGAL|gmp|mpfr|rounding-math|ffp-contract=off -fno-fast-math")
  message(SEND_ERROR "what the oracle is compiled with reaches its users: ${CMAKE_MATCH_0}")
endif()

# The failing assertion of each program tells what a person needs; the holding one nothing.
set(line "sphere 0x0p+0 0x0p+0 0x0p+0 0x1p+0 ray 0x0p+0 0x1p-1 -0x1.8p+1 0x0p+0 0x0p+0 0x1p+0")
string(CONCAT in_float
  "case ${line} got miss truth hit 0x1.112614p+1 (2.1339746) "
  "verdict false_miss: a miss where there is a hit "
  "margin 1.6e6 u in float: no rounding of the case excuses it "
  "explain rayaudit explain --format float '${line} miss'")
string(CONCAT in_double
  "case ${line} got miss truth hit 0x1.1126145e9ecd5p+1 (2.133974596215561) "
  "verdict false_miss: a miss where there is a hit "
  "margin 8.4e14 u in double: no rounding of the case excuses it "
  "explain rayaudit explain '${line} miss'")
foreach(program c boost gtest catch2)
  if(NOT EXISTS ${TO}/outside/with_${program})
    message("not tried, for it is not installed here: ${program}")
    continue()
  endif()
  run(code text ${TO}/outside/with_${program})
  if(code EQUAL 0)
    message(SEND_ERROR "with_${program} should fail")
  elseif(program STREQUAL "c")
    require_words(with_c "${text}" "sphere: expected radius, got `one` ${in_double}")
  else()
    require_words(with_${program} "${text}" "${in_float}")
    string(REGEX MATCHALL "explain rayaudit" failures "${text}")
    list(LENGTH failures count)
    if(NOT count EQUAL 1)
      message(SEND_ERROR "with_${program}: expected one failure, got ${count} in\n${text}")
    endif()
  endif()
endforeach()

# The audits that the project registers.
foreach(audit
    "keeps_its_bounds=Passed=spheres/double"
    "breaks_its_bounds=Failed=is broken by spheres/double on sphere, family anywhere: max_ulp"
    "plugin_by_its_file=Passed=spheres/double"
    "wrong_by_default=Failed=--fail-on: spheres/double on sphere, family behind"
    "program=Passed=sed/double")
  string(REGEX MATCH "^(.*)=(.*)=(.*)$" parts ${audit})
  set(name ${CMAKE_MATCH_1})
  set(ended ${CMAKE_MATCH_2})
  set(words ${CMAKE_MATCH_3})
  run(code text ${CMAKE_CTEST_COMMAND} --test-dir ${TO}/outside -L rayaudit -R "^${name}$" -V)
  if(NOT text MATCHES "${name} \\.+ *(\\*\\*\\*)?${ended}")
    message(SEND_ERROR "${audit}, but\n${text}")
  endif()
  require_words(${name} "${text}" "${words}")
endforeach()

# What is given wrongly is refused by name.
foreach(given
    "TARGET|no_plugin=NAME is missing"
    "NAME|a=expected one of TARGET, PLUGIN and PROGRAM, got ``"
    "NAME|a|TARGET|t|PLUGIN|p=got `TARGET PLUGIN`"
    "NAME|a|TARGET|nowhere=there is no target `nowhere` so far"
    "NAME|a|TARGET|no_plugin=target `no_plugin` is no plugin"
    "NAME|a|PLUGIN|p|BOUND|b=`BOUND b` is not known"
    "NAME|a|PLUGIN|p|BOUNDS=nothing follows BOUNDS"
    "NAME|a|PLUGIN|p|BOUNDS|none.txt=there is no file of BOUNDS"
    "NAME|a|PLUGIN|p|FORMAT|float=FORMAT is for a PROGRAM"
    "NAME|a|PROGRAM|p=FORMAT is to be said"
    "NAME|a|PROGRAM|p|FORMAT|half=FORMAT is float, double or long_double, not `half`"
    "NAME|a|PLUGIN|p|CASES|many=CASES is a whole number"
    "NAME|a|PLUGIN|p|SEED|-1=SEED is a whole number")
  string(REGEX MATCH "^([^=]*)=(.*)$" parts "${given}")
  set(wanted "${CMAKE_MATCH_2}")
  run(code text ${CMAKE_COMMAND} -G ${GENERATOR} -D CMAKE_PREFIX_PATH=${TO}/usr
    "-DGIVEN=${CMAKE_MATCH_1}" -S ${here}/refused -B ${TO}/refused)
  require_words("rayaudit_add_audit(${CMAKE_MATCH_1})" "${text}" "${wanted}")
endforeach()

# The program is there with what it looks for; a package holds nothing for one processor alone.
run(code text ${TO}/usr/bin/rayaudit list subjects)
require_words("the installed program" "${text}" "textbook+fast_math/float")
file(GLOB native ${TO}/usr/lib/rayaudit/*native*)
if(AS STREQUAL "package" AND native)
  message(SEND_ERROR "${native} is for the processor of the machine that made the package")
elseif(AS STREQUAL "files" AND NOT native)
  message(SEND_ERROR "rayaudit-native.so is not installed")
endif()
foreach(file bounds/robust.txt cases/handout.txt)
  if(NOT EXISTS ${TO}/usr/share/rayaudit/${file})
    message(SEND_ERROR "share/rayaudit/${file} is not installed")
  endif()
endforeach()
