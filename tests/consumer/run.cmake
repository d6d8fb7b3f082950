# SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
# SPDX-License-Identifier: Apache-2.0
# Configures the project here against the installed estimator (LIBRARY_BUILD: our build folder) or
# with it as a part (LIBRARY_SOURCE: our sources), in the folder WORK, and checks that it finds no
# more than it needs and gets none of our flags. Installed, it is built and run on the sequence
# SCENE, and must find the trajectory TRAJECTORY of the program.
cmake_minimum_required(VERSION 3.25)

include("${CMAKE_CURRENT_LIST_DIR}/run_command.cmake")

file(REMOVE_RECURSE "${WORK}")
set(arguments -S "${CMAKE_CURRENT_LIST_DIR}" -B "${WORK}/build" -G "${GENERATOR}"
              "-DCMAKE_CXX_COMPILER=${COMPILER}")
if(LIBRARY_BUILD)
  run("${CMAKE_COMMAND}" --install "${LIBRARY_BUILD}" --prefix "${WORK}/prefix" --component library)
  list(APPEND arguments "-DCMAKE_PREFIX_PATH=${WORK}/prefix")
else()
  list(APPEND arguments "-DCLUSTERVO_SOURCE_DIR=${LIBRARY_SOURCE}")
endif()
run("${CMAKE_COMMAND}" ${arguments})

# An installed library of ours has the back end of Ceres; by itself it is not built.
if(NOT LIBRARY_BUILD)
  set(ceres "Ceres|")
endif()
file(STRINGS "${WORK}/build/CMakeCache.txt" found
     REGEX "^(${ceres}GTest|CLI11|nlohmann_json|benchmark|pybind11)_DIR|OPENSSL|TIFF")
if(found)
  message(FATAL_ERROR "the estimator alone looks for ${found}")
endif()
file(READ "${WORK}/build/compile_commands.json" commands)
string(REGEX MATCH "\"command\": \"[^\"]*main\\.cc\\.o[^\"]*\"" command "${commands}")
if(NOT command OR command MATCHES " -W| -ffp-contract")
  message(FATAL_ERROR "flags of ours reach those who link us: ${command}")
endif()

if(LIBRARY_SOURCE AND commands MATCHES " -Werror")
  message(FATAL_ERROR "a warning of ours ends the build of others")
endif()

if(LIBRARY_BUILD)
  run("${CMAKE_COMMAND}" --build "${WORK}/build")
  run("${WORK}/build/consumer" "${SCENE}" "${WORK}/camera.tum")
  if(NOT output STREQUAL "Ball tracked\nChair tracked\nBall tracked\n")
    message(FATAL_ERROR "found ${output}expected the two balls and the chair, tracked")
  endif()
  run("${CMAKE_COMMAND}" -E compare_files "${WORK}/camera.tum" "${TRAJECTORY}")
endif()
