# Makes the archive of a release, build/release/lvsm-VERSION.zip, which is what `cmake --install` installs:
#   cmake -P cmake/release.cmake
cmake_minimum_required(VERSION 3.22)
cmake_path(GET CMAKE_CURRENT_LIST_DIR PARENT_PATH source)
if(NOT FOLDER)
  set(FOLDER ${source}/build/release)
endif()
execute_process(COMMAND ${CMAKE_COMMAND} -S ${source} -B ${FOLDER} -D LVSM_BUILD_TESTS=OFF -D LVSM_BUILD_EXAMPLES=OFF
  -D LVSM_BUILD_WASM=ON
  COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${CMAKE_COMMAND} --build ${FOLDER} --target package COMMAND_ERROR_IS_FATAL ANY)
