# Installs the build tree BUILD into a scratch prefix, builds the projects in SOURCE against it and runs them; and one that
# takes the sources ROOT as a subdirectory.
file(REMOVE_RECURSE ${SCRATCH})
file(MAKE_DIRECTORY ${SCRATCH})

function(run)
  execute_process(COMMAND ${ARGN} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

# Whether users can build with the library is the question, not how fast that is: nothing is optimized.
function(configure source build)
  string(TOUPPER "${CONFIG}" config)
  run(${CMAKE_COMMAND} -S ${source} -B ${SCRATCH}/${build} -G ${GENERATOR} -DCMAKE_BUILD_TYPE=${CONFIG}
      -DCMAKE_CXX_COMPILER=${CXX} -DCMAKE_CXX_FLAGS=${FLAGS} -DCMAKE_CXX_FLAGS_${config}=-O0
      -DCMAKE_PREFIX_PATH=${SCRATCH}/prefix ${ARGN})
endfunction()

execute_process(COMMAND ${CMAKE_COMMAND} --install ${BUILD} --prefix ${SCRATCH}/prefix --config ${CONFIG}
                OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
file(GLOB_RECURSE headers RELATIVE ${SCRATCH}/prefix/include ${SCRATCH}/prefix/include/*.h)
foreach(header IN LISTS headers)
  if(NOT header MATCHES "^arcway/[a-z0-9_]+\\.h$|^arcway/(accel|datasets)/[a-z0-9_]+\\.h$")
    message(FATAL_ERROR "${header}: no public header, but installed")
  endif()
endforeach()

configure(${SOURCE} build -DWITH_ACCEL=${WITH_ACCEL} -DREADME_LINES=${ROOT}/bench/suites -DEXAMPLES=${ROOT}/tests/examples)
run(${CMAKE_COMMAND} --build ${SCRATCH}/build --config ${CONFIG})
run(${SCRATCH}/build/consumer)
if(WITH_ACCEL)
  run(${SCRATCH}/build/accel_consumer)
endif()

configure(${SOURCE}/core_only core_only)
run(${CMAKE_COMMAND} --build ${SCRATCH}/core_only --config ${CONFIG})
run(${SCRATCH}/core_only/core_consumer)

configure(${SOURCE}/subproject subproject -DARCWAY_SOURCE=${ROOT})
run(${CMAKE_COMMAND} --build ${SCRATCH}/subproject --config ${CONFIG} --target subproject_consumer library_source)
