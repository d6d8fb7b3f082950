# SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
# SPDX-License-Identifier: Apache-2.0
# One hash over path and content of all .h and .cc files below some folders of ROOT
# (comma-separated), in the order of the paths. For scripts that run at build time. Without
# plausib*: they warn of input and decide no value.
function(hash_sources folders result)
  string(REPLACE "," ";" folders "${folders}")
  set(files)
  foreach(folder IN LISTS folders)
    file(GLOB_RECURSE found RELATIVE "${ROOT}" "${ROOT}/${folder}/*.h" "${ROOT}/${folder}/*.cc")
    list(APPEND files ${found})
  endforeach()
  list(FILTER files EXCLUDE REGEX "/plausib[^/]*$")
  list(SORT files COMPARE STRING)
  set(listing "")
  foreach(file IN LISTS files)
    file(SHA256 "${ROOT}/${file}" hash)
    string(APPEND listing "${hash}  ${file}\n")
  endforeach()
  string(SHA256 hash "${listing}")
  set(${result} ${hash} PARENT_SCOPE)
endfunction()
