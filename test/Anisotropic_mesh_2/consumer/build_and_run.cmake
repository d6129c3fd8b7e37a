# Builds and runs the project beside this file in SCRATCH_DIR, which gets the
# package as WAY says: `installed` there first, or `from_source`.

function(run)
  execute_process(COMMAND ${ARGN} COMMAND_ECHO STDOUT RESULT_VARIABLE result)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "failed with ${result}: ${ARGN}")
  endif()
endfunction()

file(REMOVE_RECURSE ${SCRATCH_DIR})
if(WAY STREQUAL "installed")
  set(prefix ${SCRATCH_DIR}/prefix)
  run(${CMAKE_COMMAND} --install ${BUILD_DIR} --config ${CONFIG} --prefix ${prefix})
  set(where -DCMAKE_PREFIX_PATH=${prefix})
else()
  set(where -DANISOTROPIC_MESH_2_SOURCE_DIR=${SOURCE_DIR})
endif()

run(${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR} -B ${SCRATCH_DIR}/build ${where}
    -DCMAKE_BUILD_TYPE=${CONFIG} -DCMAKE_CXX_COMPILER=${CXX_COMPILER} -DCGAL_DIR=${CGAL_DIR})
run(${CMAKE_COMMAND} --build ${SCRATCH_DIR}/build --config ${CONFIG})
run(${CMAKE_CTEST_COMMAND} --test-dir ${SCRATCH_DIR}/build -C ${CONFIG} --no-tests=error --verbose)

if(WAY STREQUAL "installed" AND EXISTS ${BUILD_DIR}/program/anisotropic_mesh_2)
  run(${prefix}/bin/anisotropic_mesh_2 --version)
endif()
