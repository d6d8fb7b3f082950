# SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
# SPDX-License-Identifier: Apache-2.0
# Runs a command, whose `output` the caller gets; ends the script where it fails.
function(run)
  execute_process(COMMAND ${ARGV} RESULT_VARIABLE code OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT code EQUAL 0)
    list(JOIN ARGV " " command)
    message(FATAL_ERROR "${command}\n${output}")
  endif()
  set(output "${output}" PARENT_SCOPE)
endfunction()
