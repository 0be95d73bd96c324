# What others find Bracket by once it is installed. Included after the libraries.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

install(FILES ${PROJECT_BINARY_DIR}/include/bracket/version.h DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/bracket)

# find_package(bracket) gives bracket::bounds, its parts and bracket::report; deal.II, CHOLMOD and nlohmann-json stay
# behind the shared libraries.
set(package ${CMAKE_INSTALL_LIBDIR}/cmake/bracket)
install(EXPORT bracket NAMESPACE bracket:: FILE bracketTargets.cmake DESTINATION ${package})
configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/bracketConfig.cmake.in
  ${PROJECT_BINARY_DIR}/bracketConfig.cmake INSTALL_DESTINATION ${package})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/bracketConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/bracketConfig.cmake ${PROJECT_BINARY_DIR}/bracketConfigVersion.cmake
        DESTINATION ${package})

# pkg-config bracket: the same for other build systems. The file finds its prefix from where it lies.
file(RELATIVE_PATH BRACKET_PREFIX ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig ${CMAKE_INSTALL_PREFIX})
string(REGEX REPLACE "/$" "" BRACKET_PREFIX "${BRACKET_PREFIX}")
cmake_path(APPEND BRACKET_LIBDIR "\${prefix}" ${CMAKE_INSTALL_LIBDIR})
cmake_path(APPEND BRACKET_INCLUDEDIR "\${prefix}" ${CMAKE_INSTALL_INCLUDEDIR})
get_property(libraries GLOBAL PROPERTY BRACKET_LIBRARIES)
list(REVERSE libraries)  # what a library needs was added before it
list(TRANSFORM libraries PREPEND -l)
list(JOIN libraries " " BRACKET_LINK)
configure_file(${PROJECT_SOURCE_DIR}/cmake/bracket.pc.in ${PROJECT_BINARY_DIR}/bracket.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/bracket.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)

# The pages, with the scenes and meshes that they use, as they lie.
install(FILES ${PROJECT_SOURCE_DIR}/README.md ${PROJECT_SOURCE_DIR}/CONTRIBUTING.md DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(DIRECTORY ${PROJECT_SOURCE_DIR}/docs DESTINATION ${CMAKE_INSTALL_DOCDIR}
        PATTERN site EXCLUDE PATTERN make.sh EXCLUDE PATTERN "*.awk" EXCLUDE PATTERN head.md EXCLUDE)
