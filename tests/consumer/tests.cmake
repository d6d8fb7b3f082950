# SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
# SPDX-License-Identifier: Apache-2.0
# The estimator as others use it: as an installed library, as a part of their build and from Python.
if(CVO_SANITIZE OR NOT CVO_OSMESA)
  return()
endif()

# A scene, and what the program finds in it.
set(library_folder "${PROJECT_BINARY_DIR}/tests/consumer")
add_test(NAME library.render
         COMMAND clustervo synth render tiny -o "${library_folder}/tiny")
add_test(NAME library.run COMMAND clustervo run "${library_folder}/tiny" --force --detections good
                                  --landmarks -o "${library_folder}/run")
set_tests_properties(library.render library.run PROPERTIES
  ENVIRONMENT "CLUSTERVO_CACHE=${library_folder}/cache")
set_tests_properties(library.render PROPERTIES FIXTURES_SETUP library_scene)
set_tests_properties(library.run PROPERTIES FIXTURES_SETUP library_run
                                            FIXTURES_REQUIRED library_scene)

set(consumer "${CMAKE_COMMAND}" "-DCOMPILER=${CMAKE_CXX_COMPILER}" "-DGENERATOR=${CMAKE_GENERATOR}")
set(consumer_script -P "${CMAKE_CURRENT_LIST_DIR}/run.cmake")
if(CVO_INSTALL)
  add_test(NAME library.installed
           COMMAND ${consumer} "-DLIBRARY_BUILD=${PROJECT_BINARY_DIR}"
                   "-DWORK=${library_folder}/installed" "-DSCENE=${library_folder}/tiny"
                   "-DTRAJECTORY=${library_folder}/run/camera.tum" ${consumer_script})
  set_tests_properties(library.installed PROPERTIES FIXTURES_REQUIRED "library_scene;library_run")
  add_test(NAME program.installed
           COMMAND "${CMAKE_COMMAND}" "-DPROGRAM_BUILD=${PROJECT_BINARY_DIR}"
                   "-DWORK=${library_folder}/program" -P "${CMAKE_CURRENT_LIST_DIR}/program.cmake")
endif()
add_test(NAME library.subproject
         COMMAND ${consumer} "-DLIBRARY_SOURCE=${PROJECT_SOURCE_DIR}"
                 "-DWORK=${library_folder}/subproject" ${consumer_script})

if(CVO_PYTHON)
  add_test(NAME library.python
           COMMAND "${CVO_PYTHON_EXECUTABLE}" -B
                   "${PROJECT_SOURCE_DIR}/tests/experiments/python/package_test.py"
                   "${PROJECT_SOURCE_DIR}/experiments/python/README.md"
           WORKING_DIRECTORY "${library_folder}")
  set_tests_properties(library.python PROPERTIES
    ENVIRONMENT "PYTHONPATH=${PROJECT_BINARY_DIR}/python"
    FIXTURES_REQUIRED "library_scene;library_run")
endif()
