# SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
# SPDX-License-Identifier: Apache-2.0
# cmake -D ROOT=<scratch folder> -P hash_sources_test.cmake: the hash of sources follows what decides
# values, and not what only warns.
cmake_minimum_required(VERSION 3.25)
include("${CMAKE_CURRENT_LIST_DIR}/../../../core/files/hash_sources.cmake")
file(REMOVE_RECURSE "${ROOT}")
file(WRITE "${ROOT}/core/a.cc" "1")
hash_sources("core" before)
file(WRITE "${ROOT}/core/plausible_boxes.cc" "1")
hash_sources("core" warned)
file(WRITE "${ROOT}/core/a.cc" "2")
hash_sources("core" after)
if(NOT warned STREQUAL before OR after STREQUAL before)
  message(FATAL_ERROR "found hashes ${before}, ${warned}, ${after}, expected that only the last differs")
endif()
