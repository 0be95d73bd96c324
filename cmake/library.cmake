include_guard()
include(GNUInstallDirs)

# bracket_library(name HEADERS headers… SOURCES sources…): the folder's target bracket_name, called bracket::name where
# it is used from outside. HEADERS are those that its users include, with their paths from the top; they are installed.
# The property BRACKET_LIBRARIES collects the targets, for bracket.pc.
function(bracket_library name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "HEADERS;SOURCES")
  add_library(bracket_${name} SHARED ${arg_SOURCES})
  add_library(bracket::${name} ALIAS bracket_${name})
  target_include_directories(bracket_${name} PUBLIC
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}> $<BUILD_INTERFACE:${PROJECT_BINARY_DIR}/include>
    $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/bracket> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  target_compile_features(bracket_${name} PUBLIC cxx_std_20)
  # Its functions call its own copies of templates, never those of a program with other flags.
  target_link_options(bracket_${name} PRIVATE -Wl,-Bsymbolic-functions)
  target_precompile_headers(bracket_${name} REUSE_FROM bracket_precompiled)
  target_compile_definitions(bracket_${name} PRIVATE $<TARGET_PROPERTY:fmt::fmt,INTERFACE_COMPILE_DEFINITIONS>)
  set_target_properties(bracket_${name} PROPERTIES
    EXPORT_NAME ${name} VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
  set_property(GLOBAL APPEND PROPERTY BRACKET_LIBRARIES bracket_${name})
  install(TARGETS bracket_${name} EXPORT bracket LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
  foreach(header IN LISTS arg_HEADERS)
    cmake_path(GET header PARENT_PATH folder)
    install(FILES ${PROJECT_SOURCE_DIR}/${header} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/bracket/${folder})
  endforeach()
endfunction()
