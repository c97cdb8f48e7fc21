# What `cmake --install` installs: geometry and mapper as the CMake package
# Tokay (component "library"), and the programs (component "programs").
include(CMakePackageConfigHelpers)
include(GNUInstallDirs)

set(packageFolder ${CMAKE_INSTALL_LIBDIR}/cmake/Tokay)
foreach(part common dense geometry mapper)
    string(SUBSTRING ${part} 0 1 first)
    string(SUBSTRING ${part} 1 -1 rest)
    string(TOUPPER ${first} first)
    set(target tokay${first}${rest})
    set_target_properties(${target} PROPERTIES EXPORT_NAME ${part} INSTALL_RPATH "$ORIGIN")
    install(TARGETS ${target} EXPORT TokayTargets COMPONENT library
            INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/tokay)
endforeach()
foreach(part common geometry mapper)
    foreach(folder ${CMAKE_SOURCE_DIR} ${CMAKE_BINARY_DIR})
        install(DIRECTORY ${folder}/src/${part} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/tokay
                COMPONENT library FILES_MATCHING PATTERN "*.hpp"
                PATTERN CMakeFiles EXCLUDE)
    endforeach()
endforeach()
install(EXPORT TokayTargets NAMESPACE Tokay:: DESTINATION ${packageFolder} COMPONENT library)

configure_package_config_file(${CMAKE_SOURCE_DIR}/cmake/TokayConfig.cmake.in
    ${CMAKE_BINARY_DIR}/TokayConfig.cmake INSTALL_DESTINATION ${packageFolder})
write_basic_package_version_file(${CMAKE_BINARY_DIR}/TokayConfigVersion.cmake
    COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_BINARY_DIR}/TokayConfig.cmake ${CMAKE_BINARY_DIR}/TokayConfigVersion.cmake
        DESTINATION ${packageFolder} COMPONENT library)

set(programs tokay-map)
if(TARGET igaStructure)
    list(APPEND programs igaStructure)
endif()
set_target_properties(${programs} PROPERTIES INSTALL_RPATH "$ORIGIN/../${CMAKE_INSTALL_LIBDIR}")
install(TARGETS ${programs} COMPONENT programs)
