# The libraries of this build are tested by the programs of another, BRACKET_TESTED_BY: what is compiled there is not
# compiled again. The loader is told to take these libraries, and the sanitizers' own before all others, as programs that
# are not built with them have to.
set(tests ${BRACKET_TESTED_BY}/tests/of_libraries.cmake)
if(NOT EXISTS ${tests})
  message(FATAL_ERROR "${BRACKET_TESTED_BY} holds no tests: build the preset release before, or set BRACKET_TESTED_BY= "
    "to build the tests here")
endif()
get_property(libraries GLOBAL PROPERTY BRACKET_LIBRARIES)
set(folders)
foreach(library IN LISTS libraries)
  list(APPEND folders $<TARGET_FILE_DIR:${library}>)
endforeach()
list(JOIN folders : folders)
execute_process(COMMAND ${CMAKE_CXX_COMPILER} -print-file-name=libasan.so
  OUTPUT_VARIABLE runtime OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)

function(bracket_test_of_libraries name environment program)
  add_test(NAME ${name} COMMAND ${program} ${ARGN})
  set_tests_properties(${name} PROPERTIES
    ENVIRONMENT "${environment};LD_LIBRARY_PATH=${folders};LD_PRELOAD=${runtime}")
endfunction()
include(${tests})
