# What programs that use the library need: headers, both libraries, and descriptions of them for CMake and pkg-config. All
# of it can be moved to another prefix.
include(CMakePackageConfigHelpers)
set(config_folder ${CMAKE_INSTALL_LIBDIR}/cmake/lichtraum)

install(TARGETS lichtraum_shared EXPORT lichtraum
  LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT library NAMELINK_COMPONENT development)
install(TARGETS lichtraum_library EXPORT lichtraum_static
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development)
foreach(library lichtraum_shared lichtraum_library)
  target_include_directories(${library} INTERFACE $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>
    $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/lichtraum/kernels>)
endforeach()
install(DIRECTORY include/lichtraum DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT development)
install(FILES ${PROJECT_BINARY_DIR}/include/lichtraum/version.hpp
  DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/lichtraum COMPONENT development)
# The lists that host and device share.
install(FILES kernels/shared/phong_fields.h kernels/shared/pbr_fields.h kernels/shared/integrators.h
  DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/lichtraum/kernels/shared COMPONENT development)

foreach(name lichtraum lichtraum_static)
  install(EXPORT ${name} FILE ${name}_targets.cmake NAMESPACE lichtraum:: DESTINATION ${config_folder}
    COMPONENT development)
endforeach()
configure_package_config_file(cmake/lichtraumConfig.cmake.in lichtraumConfig.cmake
  INSTALL_DESTINATION ${config_folder})
write_basic_package_version_file(lichtraumConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/lichtraumConfig.cmake ${PROJECT_BINARY_DIR}/lichtraumConfigVersion.cmake
  DESTINATION ${config_folder} COMPONENT development)

file(RELATIVE_PATH PREFIX_FROM_PC ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig ${CMAKE_INSTALL_PREFIX})
configure_file(cmake/lichtraum.pc.in lichtraum.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/lichtraum.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT development)
