# Debian packages, made by tools/package: lichtraum (the programs), liblichtraum0 (the shared library) and liblichtraum-dev.
# docs/PACKAGING.md tells what they hold. tools/package adds what only Debian asks for.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_PACKAGE_VENDOR "")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "ray tracer for scenes in plain text and models, on OpenCL")
set(CPACK_PACKAGE_CONTACT "\$ENV{DEBFULLNAME} <\$ENV{DEBEMAIL}>")  # of whoever calls cpack
set(CPACK_COMPONENTS_ALL application desktop library development)
foreach(component application desktop)
  string(TOUPPER ${component} name)
  set(CPACK_COMPONENT_${name}_GROUP application)
endforeach()
set(CPACK_COMPONENT_LIBRARY_GROUP library)
set(CPACK_COMPONENT_DEVELOPMENT_GROUP development)
set(CPACK_COMPONENTS_GROUPING ONE_PER_GROUP)
set(CPACK_DEB_COMPONENT_INSTALL ON)

set(library_package liblichtraum${PROJECT_VERSION_MAJOR})
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_ENABLE_COMPONENT_DEPENDS OFF)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
# Found where OpenCL says, not by the linker.
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "pocl-opencl-icd | opencl-icd")

set(CPACK_DEBIAN_APPLICATION_PACKAGE_NAME lichtraum)
set(CPACK_DEBIAN_APPLICATION_PACKAGE_SECTION graphics)
# The window's letters on a screen with a scale factor; without it those of Dear ImGui, larger, in steps.
set(CPACK_DEBIAN_APPLICATION_PACKAGE_RECOMMENDS "pocl-opencl-icd | opencl-icd, fonts-dejavu-core")
set(CPACK_DEBIAN_APPLICATION_PACKAGE_SUGGESTS ffmpeg)
set(CPACK_COMPONENT_APPLICATION_DESCRIPTION
  "Draws scenes in eSDF, a language of plain text, and models in glTF, OBJ, PLY
and STL: by Whitted's ray tracing or by path tracing, on processors and on
graphics cards. With a window to look around in, films, and thumbnails for
file managers.")
set(CPACK_DEBIAN_LIBRARY_PACKAGE_NAME ${library_package})
set(CPACK_DEBIAN_LIBRARY_PACKAGE_SECTION libs)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_CONTROL_EXTRA ${PROJECT_SOURCE_DIR}/packaging/triggers)
set(CPACK_COMPONENT_LIBRARY_DESCRIPTION
  "The shared library: loads scenes in eSDF and models in glTF, OBJ, PLY and
STL, takes scenes from code, and draws them on OpenCL devices, or without any.")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME liblichtraum-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SHLIBDEPS OFF)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "${library_package} (= ${PROJECT_VERSION}), libglm-dev")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_RECOMMENDS "")
set(CPACK_COMPONENT_DEVELOPMENT_DESCRIPTION
  "For programs that use the library: headers, the static library, and what
CMake and pkg-config find them by.")
include(CPack)
