include_guard()
include(GNUInstallDirs)

# bracket_library(name sources…): the folder's target bracket_name, called bracket::name where it is used from outside,
# with its front-door header name.h installed.
function(bracket_library name)
  add_library(bracket_${name} SHARED ${ARGN})
  add_library(bracket::${name} ALIAS bracket_${name})
  target_include_directories(bracket_${name} PUBLIC
    $<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}/..> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/bracket>)
  target_compile_features(bracket_${name} PUBLIC cxx_std_20)
  set_target_properties(bracket_${name} PROPERTIES EXPORT_NAME ${name} VERSION ${PROJECT_VERSION})
  install(TARGETS bracket_${name} EXPORT bracket LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
  install(FILES ${name}.h DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/bracket/${name})
endfunction()
