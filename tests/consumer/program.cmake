# SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
# SPDX-License-Identifier: Apache-2.0
# Installs the program of the build folder PROGRAM_BUILD into the folder WORK and checks that it runs
# from there, that its man page and completions are where man and the shells look, and that bash
# completes a command with them.
cmake_minimum_required(VERSION 3.25)

include("${CMAKE_CURRENT_LIST_DIR}/run_command.cmake")

file(REMOVE_RECURSE "${WORK}")
run("${CMAKE_COMMAND}" --install "${PROGRAM_BUILD}" --prefix "${WORK}" --component program)
run("${WORK}/bin/clustervo" --version)

set(completion "${WORK}/share/bash-completion/completions/clustervo")
foreach(found "man/man1/clustervo.1\n[.]SS clustervo experiment run"
              "bash-completion/completions/clustervo\ncomplete -o filenames -F"
              "zsh/site-functions/_clustervo\n^#compdef clustervo"
              "fish/vendor_completions.d/clustervo.fish\ncomplete -c clustervo")
  string(REPLACE "\n" ";" found "${found}")
  list(GET found 0 file)
  list(GET found 1 text)
  file(READ "${WORK}/share/${file}" content)
  if(NOT content MATCHES "${text}")
    message(FATAL_ERROR "share/${file}: found no \"${text}\"")
  endif()
endforeach()

function(completes expected)
  list(LENGTH ARGN count)
  math(EXPR current "${count} - 1")
  list(JOIN ARGN "' '" words)
  run(bash -c "source '${completion}' && COMP_WORDS=('${words}') && COMP_CWORD=${current} && _clustervo && \
               echo -n \"\${COMPREPLY[*]}\"")
  if(NOT output STREQUAL expected)
    message(FATAL_ERROR "${ARGN}: found \"${output}\", expected \"${expected}\"")
  endif()
endfunction()
completes("experiment explain" clustervo ex)
completes("run" clustervo experiment r)
completes("--output" clustervo experiment run --ou)
