# cmake -DBUILD=… -DSOURCE=… -DCONFIG=… -DCXX=… -P build.cmake: installs the package into the build folder, builds and
# runs the consumer against it, once by find_package() and, where there is a pkg-config, once by that, makes sure that it
# saw no header of deal.II or of the JSON library, and runs a scene by the Python module, where there is one.
function(run)
  execute_process(COMMAND ${ARGV} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

# Runs a consumer in a folder of its own, and reads what it leaves there.
function(run_consumer program)
  set(folder ${program}.out)
  file(MAKE_DIRECTORY ${folder})
  execute_process(COMMAND ${program} WORKING_DIRECTORY ${folder} COMMAND_ERROR_IS_FATAL ANY)
  file(READ ${folder}/report.json report)
  string(JSON guarantee GET ${report} guarantee)
  string(JSON levels LENGTH ${report} levels)
  math(EXPR last "${levels} - 1")
  string(JSON cells GET ${report} levels ${last} cells)
  math(EXPR parts "3 * ${cells}")
  file(STRINGS ${folder}/solution.vtu piece REGEX "NumberOfCells=\"${parts}\"")
  if(NOT guarantee STREQUAL "rounding-safe" OR NOT piece)
    message(FATAL_ERROR "the files of ${program} are not what they should be:\n${report}")
  endif()
endfunction()

set(prefix ${BUILD}/consumer/prefix)
file(REMOVE_RECURSE ${BUILD}/consumer)
run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${prefix})
foreach(file share/man/man1/bracket.1 share/bash-completion/completions/bracket)
  if(NOT EXISTS ${prefix}/${file})
    message(FATAL_ERROR "${file} is not installed")
  endif()
endforeach()
run(${CMAKE_COMMAND} -S ${SOURCE} -B ${BUILD}/consumer/build -G Ninja -DCMAKE_BUILD_TYPE=${CONFIG}
    -DCMAKE_PREFIX_PATH=${prefix} "-DCMAKE_CXX_FLAGS=-MD" -DCMAKE_EXPORT_COMPILE_COMMANDS=ON)
run(${CMAKE_COMMAND} --build ${BUILD}/consumer/build)
run_consumer(${BUILD}/consumer/build/consumer)

execute_process(COMMAND ninja -C ${BUILD}/consumer/build -t deps OUTPUT_VARIABLE headers COMMAND_ERROR_IS_FATAL ANY)
if(NOT headers MATCHES "include/bracket/bounds/bounds.h" OR headers MATCHES "deal.II|cholmod|nlohmann")
  message(FATAL_ERROR "the consumer's includes are not what they should be:\n${headers}")
endif()

find_program(PKG_CONFIG pkg-config)
if(PKG_CONFIG)
  file(GLOB_RECURSE file ${prefix}/bracket.pc)
  cmake_path(GET file PARENT_PATH folder)
  set(ENV{PKG_CONFIG_PATH} ${folder})
  execute_process(COMMAND ${PKG_CONFIG} --cflags --libs bracket OUTPUT_VARIABLE flags COMMAND_ERROR_IS_FATAL ANY)
  execute_process(COMMAND ${PKG_CONFIG} --variable=libdir bracket OUTPUT_VARIABLE libraries
                  OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
  separate_arguments(flags UNIX_COMMAND "${flags}")
  run(${CXX} -std=c++20 ${SOURCE}/main.cpp -o ${BUILD}/consumer/by_pkg_config ${flags} -Wl,-rpath,${libraries})
  run_consumer(${BUILD}/consumer/by_pkg_config)
endif()

file(GLOB_RECURSE module ${prefix}/_bracket.*)
if(module)
  cmake_path(GET module PARENT_PATH package)
  cmake_path(GET package PARENT_PATH folder)
  set(ENV{PYTHONPATH} ${folder})
  file(GLOB_RECURSE scene ${prefix}/share/bracket/scenes/patch.toml)
  list(FILTER scene EXCLUDE REGEX "/space/")
  run(${PYTHON} -c "import bracket
assert bracket.__file__.startswith('${prefix}')
assert bracket.run(bracket.read_scene('${scene}')).guarantee == 'rounding-safe'")
endif()
run(${CMAKE_COMMAND} -E echo "[  PASSED  ] 1 test.")  # tests/run.sh counts it among GoogleTest's
