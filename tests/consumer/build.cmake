# cmake -DBUILD=… -DSOURCE=… -DCONFIG=… -P build.cmake: installs the package into the build folder, builds and runs the
# consumer against it, and makes sure that it saw no header of deal.II.
function(run)
  execute_process(COMMAND ${ARGV} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

set(prefix ${BUILD}/consumer/prefix)
file(REMOVE_RECURSE ${BUILD}/consumer)
run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${prefix})
run(${CMAKE_COMMAND} -S ${SOURCE} -B ${BUILD}/consumer/build -G Ninja -DCMAKE_BUILD_TYPE=${CONFIG}
    -DCMAKE_PREFIX_PATH=${prefix} "-DCMAKE_CXX_FLAGS=-MD" -DCMAKE_EXPORT_COMPILE_COMMANDS=ON)
run(${CMAKE_COMMAND} --build ${BUILD}/consumer/build)
run(${BUILD}/consumer/build/consumer)

execute_process(COMMAND ninja -C ${BUILD}/consumer/build -t deps OUTPUT_VARIABLE headers COMMAND_ERROR_IS_FATAL ANY)
if(NOT headers MATCHES "include/bracket/bounds/bounds.h" OR headers MATCHES "deal.II|cholmod")
  message(FATAL_ERROR "the consumer's includes are not what they should be:\n${headers}")
endif()
run(${CMAKE_COMMAND} -E echo "[  PASSED  ] 1 test.")  # tests/run.sh counts it among GoogleTest's
