# What is installed, and packed by `cpack` or cmake/release.cmake: headers, shader files, the one-file versions and how to
# make others, lvsm.mjs, the licence; lvsm for find_package and for pkg-config. Nothing depends on where it is installed.
include(CMakePackageConfigHelpers)
set(shader_root ${CMAKE_INSTALL_DATADIR}/lvsm)
set(package ${CMAKE_INSTALL_DATADIR}/cmake/lvsm)

install(DIRECTORY include/lvsm DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(DIRECTORY glsl hlsl wgsl DESTINATION ${shader_root})
install(FILES ${singles} DESTINATION ${shader_root}/single)
install(FILES cmake/single_file.cmake DESTINATION ${shader_root}/cmake)
# Where there is what it needs.
install(FILES ${PROJECT_BINARY_DIR}/wasm/lvsm.mjs ${PROJECT_BINARY_DIR}/wasm/lvsm.d.mts DESTINATION ${shader_root}/host OPTIONAL)
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})

install(TARGETS lvsm EXPORT lvsm)
install(EXPORT lvsm NAMESPACE lvsm:: FILE lvsmTargets.cmake DESTINATION ${package})
configure_package_config_file(cmake/lvsmConfig.cmake.in lvsmConfig.cmake
  INSTALL_DESTINATION ${package} PATH_VARS shader_root)
write_basic_package_version_file(lvsmConfigVersion.cmake COMPATIBILITY SameMinorVersion ARCH_INDEPENDENT)
install(FILES ${PROJECT_BINARY_DIR}/lvsmConfig.cmake ${PROJECT_BINARY_DIR}/lvsmConfigVersion.cmake
  DESTINATION ${package})

# pkg-config knows where the .pc file lies; everything else is named from there.
set(pkgconfig ${CMAKE_INSTALL_FULL_DATADIR}/pkgconfig)
file(RELATIVE_PATH to_include ${pkgconfig} ${CMAKE_INSTALL_FULL_INCLUDEDIR})
file(RELATIVE_PATH to_shaders ${pkgconfig} ${CMAKE_INSTALL_FULL_DATADIR}/lvsm)
configure_file(cmake/lvsm.pc.in lvsm.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/lvsm.pc DESTINATION ${CMAKE_INSTALL_DATADIR}/pkgconfig)

if(PROJECT_IS_TOP_LEVEL)
  set(CPACK_GENERATOR ZIP)
  set(CPACK_PACKAGE_FILE_NAME lvsm-${PROJECT_VERSION})
  set(CPACK_VERBATIM_VARIABLES ON)
  include(CPack)
endif()
