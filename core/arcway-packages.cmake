# Debian packages made by `cpack`: shared libraries, what programs that use them are built with, and the tool.
set(runtime libarcway${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
set(exactly "(= ${PROJECT_VERSION})")

# Each package has its own copy of the license, where Debian's policy wants it.
foreach(part IN ITEMS runtime:${runtime} dev:libarcway-dev tool:arcway)
  string(REPLACE ":" ";" part ${part})
  list(GET part 0 component)
  list(GET part 1 package)
  install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${package} RENAME copyright COMPONENT ${component})
  string(TOUPPER ${component} upper)
  set(CPACK_DEBIAN_${upper}_PACKAGE_NAME ${package})
endforeach()

set(CPACK_GENERATOR DEB)
set(CPACK_COMPONENTS_ALL runtime dev tool)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_PACKAGE_CONTACT "The arcway maintainers <maintainers@arcway.invalid>")
set(CPACK_PACKAGING_INSTALL_PREFIX ${CMAKE_INSTALL_PREFIX})
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${PROJECT_BINARY_DIR}/core ${PROJECT_BINARY_DIR}/accel
                                                ${PROJECT_BINARY_DIR}/datasets)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
set(CPACK_DEBIAN_RUNTIME_PACKAGE_SECTION libs)
set(CPACK_DEBIAN_DEV_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_TOOL_PACKAGE_SECTION science)
set(CPACK_DEBIAN_DEV_PACKAGE_DEPENDS "${runtime} ${exactly}, libeigen3-dev (>= 3.4)")
set(CPACK_DEBIAN_TOOL_PACKAGE_DEPENDS "${runtime} ${exactly}")
set(CPACK_COMPONENT_RUNTIME_DESCRIPTION
    "Fastest smooth paths of car-like vehicles among polygons: shared libraries\n Plans are free of collision by exact decisions.")
set(CPACK_COMPONENT_DEV_DESCRIPTION
    "Fastest smooth paths of car-like vehicles among polygons: headers\n Headers and CMake package of arcway's libraries.")
set(CPACK_COMPONENT_TOOL_DESCRIPTION
    "Fastest smooth paths of car-like vehicles among polygons: tool\n Plans on maps of many formats, checks plans, draws them and measures.")
include(CPack)
