# cmake -DBUILD=… -DCPACK=… -P check.cmake: makes the Debian package of a build folder, unpacks it, and runs the program
# in it as it lies there.
function(read variable)
  execute_process(COMMAND ${ARGN} OUTPUT_VARIABLE text OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
  set(${variable} "${text}" PARENT_SCOPE)
endfunction()

set(folder ${BUILD}/package)
file(REMOVE_RECURSE ${folder})
read(said ${CPACK} -G DEB --config ${BUILD}/CPackConfig.cmake -B ${folder})
file(GLOB package ${folder}/*.deb)
read(depends dpkg-deb --field ${package} Depends)
foreach(library libc6 libcholmod libtbb)
  if(NOT depends MATCHES ${library})
    message(FATAL_ERROR "the package does not depend on ${library}: ${depends}")
  endif()
endforeach()

execute_process(COMMAND dpkg-deb --extract ${package} ${folder}/root COMMAND_ERROR_IS_FATAL ANY)
file(GLOB_RECURSE files RELATIVE ${folder}/root ${folder}/root/*)
foreach(file bin/bracket libbracket_bounds.so include/bracket/bounds/bounds.h bracketConfig.cmake bracket.pc man1/bracket.1.gz
        bash-completion/completions/bracket doc/bracket/copyright doc/bracket/changelog.Debian.gz doc/bracket/docs/report.md
        bracket/scenes/patch.toml)
  if(NOT files MATCHES "/${file}(;|$)")
    message(FATAL_ERROR "${file} is not in the package: ${files}")
  endif()
endforeach()

function(place variable ending)  # of the one file that ends so
  set(found ${files})
  list(FILTER found INCLUDE REGEX "/${ending}$")
  set(${variable} ${folder}/root/${found} PARENT_SCOPE)
endfunction()
place(program bin/bracket)
place(library libbracket_bounds.so)
place(scene share/bracket/scenes/patch.toml)
cmake_path(GET library PARENT_PATH libraries)
set(ENV{LD_LIBRARY_PATH} ${libraries})
read(answer ${program} ${scene} --quiet --no-report -o ${folder}/patch.out)
if(NOT answer MATCHES "guaranteed error")
  message(FATAL_ERROR "the program in the package says: ${answer}")
endif()
message("[  PASSED  ] 1 test.")  # tests/run.sh counts it among GoogleTest's
