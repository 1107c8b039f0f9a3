# Installs the libraries, their headers, the program and the CMake package `mrpp`:
#   find_package(mrpp REQUIRED)
#   target_link_libraries(mine PRIVATE mrpp::framework)
include(CMakePackageConfigHelpers)

get_property(mrpp_libraries GLOBAL PROPERTY MRPP_LIBRARIES)
install(TARGETS ${mrpp_libraries} EXPORT mrppTargets
    ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}"
    FILE_SET HEADERS DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/mrppsim")
install(TARGETS mrppsim RUNTIME DESTINATION "${CMAKE_INSTALL_BINDIR}")
install(EXPORT mrppTargets NAMESPACE mrpp:: DESTINATION "${CMAKE_INSTALL_LIBDIR}/cmake/mrpp")
configure_package_config_file("${PROJECT_SOURCE_DIR}/cmake/mrppConfig.cmake.in"
    "${PROJECT_BINARY_DIR}/mrppConfig.cmake" INSTALL_DESTINATION "${CMAKE_INSTALL_LIBDIR}/cmake/mrpp")
write_basic_package_version_file("${PROJECT_BINARY_DIR}/mrppConfigVersion.cmake" COMPATIBILITY SameMinorVersion)
install(FILES "${PROJECT_BINARY_DIR}/mrppConfig.cmake" "${PROJECT_BINARY_DIR}/mrppConfigVersion.cmake"
    DESTINATION "${CMAKE_INSTALL_LIBDIR}/cmake/mrpp")
