# Libraries that people ship, where they are there, each in a plugin of its own: a new one is its
# source in this folder, how it is found, and a row in libraries.cpp.

set(library_plugins "")

# add_library_plugin(ode PkgConfig::ODE): the plugin of ode.cpp, linked to what follows its name, if
# those are targets that there are or files.
function(add_library_plugin name)
  foreach(needed IN LISTS ARGN)
    if(needed MATCHES :: AND NOT TARGET ${needed})
      return()
    endif()
  endforeach()
  add_plugin(rayaudit-${name} src/subjects/libraries/${name}.cpp)
  target_link_libraries(rayaudit-${name} PRIVATE ${ARGN} ${CMAKE_DL_LIBS})
  set(library_plugins ${library_plugins} rayaudit-${name} PARENT_SCOPE)
endfunction()

# The same of headers, and of libraries that are files: add_headers_plugin(nanovdb DIR [LIBRARY...]).
function(add_headers_plugin name headers)
  if(NOT headers OR "${ARGN}" MATCHES NOTFOUND)
    return()
  endif()
  add_library_plugin(${name} ${ARGN})
  target_include_directories(rayaudit-${name} SYSTEM PRIVATE ${headers})
  set(library_plugins ${library_plugins} PARENT_SCOPE)
endfunction()

find_package(embree 3 QUIET)
if(embree_FOUND)
  add_library_plugin(embree embree)
endif()
foreach(package glm Imath Eigen3 Coin mujoco)
  find_package(${package} CONFIG QUIET)
endforeach()
add_library_plugin(cgal CGAL::CGAL)
add_library_plugin(coin Coin::Coin)
add_library_plugin(eigen Eigen3::Eigen)
add_library_plugin(glm glm::glm)
add_library_plugin(imath Imath::Imath)
add_library_plugin(mujoco mujoco::mujoco)

find_path(NANOVDB_HEADERS nanovdb/util/Ray.h)
find_path(IRRLICHT_HEADERS irrlicht/line3d.h)
find_path(SIMGEAR_HEADERS simgear/math/SGGeometry.hxx)
add_headers_plugin(nanovdb ${NANOVDB_HEADERS})
add_headers_plugin(irrlicht ${IRRLICHT_HEADERS})
add_headers_plugin(simgear ${SIMGEAR_HEADERS})

find_package(PkgConfig QUIET)
if(PkgConfig_FOUND)
  foreach(package ode bullet geometric_shapes OGRE)
    string(TOUPPER ${package} found)
    pkg_check_modules(${found} QUIET IMPORTED_TARGET ${package})
  endforeach()
  pkg_check_modules(BULLET64 QUIET IMPORTED_TARGET bullet-float64)
  pkg_check_modules(SIMBODY QUIET simbody)
endif()
add_library_plugin(bullet PkgConfig::BULLET)
add_library_plugin(geometric_shapes PkgConfig::GEOMETRIC_SHAPES)
add_library_plugin(ode PkgConfig::ODE)
add_library_plugin(ogre PkgConfig::OGRE)
if(TARGET rayaudit-geometric_shapes)
  target_compile_definitions(rayaudit-geometric_shapes
    PRIVATE GEOMETRIC_SHAPES_VERSION="${GEOMETRIC_SHAPES_VERSION}")
endif()
if(BULLET64_FOUND)  # the same source in the other precision
  add_plugin(rayaudit-bullet64 src/subjects/libraries/bullet.cpp)
  target_link_libraries(rayaudit-bullet64 PRIVATE PkgConfig::BULLET64)
  list(APPEND library_plugins rayaudit-bullet64)
endif()
if(SIMBODY_FOUND)
  add_headers_plugin(simbody "${SIMBODY_INCLUDE_DIRS}" SimTKmath SimTKcommon)
  # Its headers are not C++20, which takes two of their comparisons for one.
  set_target_properties(rayaudit-simbody PROPERTIES CXX_STANDARD 17)
endif()

# Its own package would add definitions of windows and fonts to everything here.
find_path(OPENCASCADE_HEADERS IntAna_IntConicQuad.hxx PATH_SUFFIXES opencascade)
find_library(OPENCASCADE_LIBRARY TKGeomBase)
add_headers_plugin(opencascade ${OPENCASCADE_HEADERS} ${OPENCASCADE_LIBRARY})
if(TARGET rayaudit-opencascade)
  target_link_libraries(rayaudit-opencascade PRIVATE TKMath TKernel)
endif()

find_path(WILD_MAGIC_HEADERS Wm5IntrRay3Sphere3.h PATH_SUFFIXES libwildmagic)
find_library(WILD_MAGIC_LIBRARY Wm5Mathematics)
add_headers_plugin(wild_magic ${WILD_MAGIC_HEADERS} ${WILD_MAGIC_LIBRARY})
if(TARGET rayaudit-wild_magic)
  target_link_libraries(rayaudit-wild_magic PRIVATE Wm5Core)
  # No header tells the version, but the file's full name does: libWm5Mathematics.so.5.17.
  get_filename_component(wild_magic_file ${WILD_MAGIC_LIBRARY} REALPATH)
  string(REGEX MATCH "[0-9]+\\.[0-9]+$" wild_magic_version ${wild_magic_file})
  target_compile_definitions(rayaudit-wild_magic PRIVATE WILD_MAGIC_VERSION="${wild_magic_version}")
endif()

# A Node program beside the plugin, in npm/, is what the plugin asks. Its packages are fetched by the
# build: a small one, which tests ask, and all by the target npm_libraries.
set(npm_folder ${PROJECT_SOURCE_DIR}/src/subjects/libraries/npm)
if(NODE)
  add_library_plugin(npm nlohmann_json::nlohmann_json)
  target_compile_definitions(rayaudit-npm PRIVATE RAYAUDIT_NODE="${NODE}")
  file(GLOB npm_sources CONFIGURE_DEPENDS
    ${npm_folder}/*.mjs ${npm_folder}/package*.json ${npm_folder}/build.cmake)
  set(fetch_npm
    ${CMAKE_COMMAND} -D SOURCE=${npm_folder} -D BUILD=${PROJECT_BINARY_DIR}/npm -D NPM=${NPM})
  add_custom_command(OUTPUT npm/made DEPENDS ${npm_sources} VERBATIM
    COMMENT "Fetching a small library from npm"
    COMMAND ${fetch_npm} -P ${npm_folder}/build.cmake
    COMMAND ${CMAKE_COMMAND} -E touch npm/made)
  add_custom_target(npm_library DEPENDS ${PROJECT_BINARY_DIR}/npm/made)
  add_custom_target(npm_libraries VERBATIM
    COMMAND ${fetch_npm} -D ALL=ON -P ${npm_folder}/build.cmake)
  add_dependencies(npm_libraries npm_library rayaudit-npm)
  add_dependencies(rayaudit-npm npm_library)
endif()
find_program(POVRAY povray)
if(POVRAY)
  add_library_plugin(povray)
  target_compile_definitions(rayaudit-povray PRIVATE RAYAUDIT_POVRAY="${POVRAY}")
endif()
