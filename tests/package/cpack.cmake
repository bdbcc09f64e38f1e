# `cpack` in the folder of a finished build makes libstagecraft-dev (headers and package files, the same on every
# architecture), libstagecraft-compiled-dev (libraries of the exact part), stagecraft (the command) and a tarball of all.
# Without the libraries or the command only the others.
set(CPACK_PACKAGE_CONTACT "stagecraft maintainers <maintainers@users.noreply.github.com>")
set(CPACK_PACKAGE_NAME stagecraft)
set(CPACK_PACKAGE_VENDOR stagecraft)
set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)
set(CPACK_GENERATOR TGZ DEB)
set(CPACK_COMPONENTS_ALL headers)
if(STAGECRAFT_COMPILED)
    list(APPEND CPACK_COMPONENTS_ALL libraries)
endif()
if(STAGECRAFT_TOOL)
    list(APPEND CPACK_COMPONENTS_ALL command)
endif()
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE
                                                WORLD_READ WORLD_EXECUTE)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)

set(CPACK_DEBIAN_HEADERS_PACKAGE_NAME libstagecraft-dev)
set(CPACK_DEBIAN_HEADERS_PACKAGE_ARCHITECTURE all)
set(CPACK_DEBIAN_HEADERS_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_HEADERS_PACKAGE_DEPENDS "libeigen3-dev (>= 3.4)")
set(CPACK_DEBIAN_HEADERS_PACKAGE_RECOMMENDS "libboost-dev (>= 1.74)")
set(CPACK_COMPONENT_HEADERS_DESCRIPTION
    "Headers of a C++20 library: Gauss, Radau, Lobatto and published tableaux
with certificates in exact arithmetic, and fast steppers for stiff equations
and differential-algebraic equations. The steppers need Eigen alone; exact
tableaux and certificates need the headers of Boost as well.")

set(CPACK_DEBIAN_LIBRARIES_PACKAGE_NAME libstagecraft-compiled-dev)
set(CPACK_DEBIAN_LIBRARIES_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_LIBRARIES_PACKAGE_DEPENDS "libstagecraft-dev (= ${PROJECT_VERSION}), libboost-dev (>= 1.74)")
set(CPACK_COMPONENT_LIBRARIES_DESCRIPTION
    "Static libraries of a C++20 library: its exact tableaux and certificates,
compiled once. Programs that link them compile in a fraction of the time
that the headers alone take.")

set(CPACK_DEBIAN_COMMAND_PACKAGE_NAME stagecraft)
set(CPACK_DEBIAN_COMMAND_PACKAGE_SECTION math)
set(CPACK_DEBIAN_COMMAND_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_COMMAND_PACKAGE_RECOMMENDS gnuplot-nox)
set(CPACK_COMPONENT_COMMAND_DESCRIPTION
    "The command of the stagecraft library: coefficients to a thousand digits,
order and stability decided in exact arithmetic, and pictures of stability
regions by gnuplot.")

# What Debian wants to find of every package below share/doc.
find_program(gzip_program gzip)
mark_as_advanced(gzip_program)
file(READ ${PROJECT_SOURCE_DIR}/LICENSE license_text)
string(STRIP "${license_text}" license_text)
string(REPLACE "\n\n" "\n.\n" license_text "${license_text}")
string(REPLACE "\n" "\n " license_text " ${license_text}")
configure_file(tests/package/copyright.in package/copyright @ONLY)
configure_file(tests/package/changelog.in package/changelog @ONLY)
if(gzip_program)
    execute_process(COMMAND ${gzip_program} -9nkf ${PROJECT_BINARY_DIR}/package/changelog COMMAND_ERROR_IS_FATAL ANY)
    foreach(component IN LISTS CPACK_COMPONENTS_ALL)
        string(TOUPPER ${component} upper)
        install(FILES ${PROJECT_BINARY_DIR}/package/copyright ${PROJECT_BINARY_DIR}/package/changelog.gz
                      ${PROJECT_SOURCE_DIR}/CHANGELOG.md
                DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${CPACK_DEBIAN_${upper}_PACKAGE_NAME} COMPONENT ${component})
    endforeach()
endif()
include(CPack)
