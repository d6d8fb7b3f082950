# SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
# SPDX-License-Identifier: Apache-2.0
# Installs the program of the build folder PROGRAM_BUILD into the folder WORK and checks that it runs
# from there.
cmake_minimum_required(VERSION 3.25)

include("${CMAKE_CURRENT_LIST_DIR}/run_command.cmake")

file(REMOVE_RECURSE "${WORK}")
run("${CMAKE_COMMAND}" --install "${PROGRAM_BUILD}" --prefix "${WORK}" --component program)
run("${WORK}/bin/clustervo" --version)
