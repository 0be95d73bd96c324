# cpack -G DEB: one binary package of program, library, headers, Python module, manual page, completion and docs. To be
# one as Debian has them it takes the prefix /usr: docs/package.md. Included after all that is installed.
if(NOT CPACK_PACKAGE_CONTACT)  # who makes the package may be told: "Name <mail>"
  set(CPACK_PACKAGE_CONTACT "The Bracket developers <bracket@localhost.localdomain>")
endif()
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "elastic bodies in contact, with guaranteed bounds of what is asked")
set(CPACK_PACKAGE_DESCRIPTION "Plane elastic bodies in contact without friction are solved twice, for
displacements and for stresses in equilibrium. Forces, displacements,
reactions, mean stresses and the energy come as intervals in which the exact
values lie for sure, rounding included.
.
This package has the program bracket, the library in C++ with its headers, the
Python module, and the documentation.")
set(CPACK_PACKAGING_INSTALL_PREFIX ${CMAKE_INSTALL_PREFIX})
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "gnuplot-nox, libopenblas0-pthread")  # pictures; a fast BLAS
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "libeigen3-dev, paraview")              # headers; fields
get_property(python GLOBAL PROPERTY BRACKET_PYTHON_VERSION)
if(python)
  set(CPACK_DEBIAN_PACKAGE_DEPENDS "python3 (>= ${python}), python3-numpy")
endif()
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
file(WRITE ${PROJECT_BINARY_DIR}/debian/triggers "activate-noawait ldconfig\n")
set(CPACK_DEBIAN_PACKAGE_CONTROL_EXTRA ${PROJECT_BINARY_DIR}/debian/triggers)
get_property(libraries GLOBAL PROPERTY BRACKET_LIBRARIES)
foreach(library IN LISTS libraries)  # where dpkg-shlibdeps finds our own
  get_target_property(folder ${library} BINARY_DIR)
  list(APPEND CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${folder})
endforeach()
set(CPACK_PRE_BUILD_SCRIPTS ${PROJECT_SOURCE_DIR}/cmake/debian_finish.cmake)
set(CPACK_BRACKET_DOC ${CMAKE_INSTALL_DOCDIR})
set(CPACK_BRACKET_MAN ${CMAKE_INSTALL_MANDIR})
set(CPACK_BRACKET_SOURCE ${PROJECT_SOURCE_DIR})
include(CPack)
