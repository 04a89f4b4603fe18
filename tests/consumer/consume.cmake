# Builds and runs project/ against the library, taken in one of three ways:
#   cmake -D WAY=find_package|add_subdirectory|copied_folder -D SOURCE=... -D BUILT=... -D WORK=... -D COMPILER=...
#         -D GENERATOR=... -D GLM=... -P consume.cmake
# SOURCE: this repository. BUILT: its build folder. WORK: a folder of this test's own.
cmake_minimum_required(VERSION 3.22)

function(run)
  execute_process(COMMAND ${ARGN} COMMAND_ECHO STDOUT COMMAND_ERROR_IS_FATAL ANY)
endfunction()

file(REMOVE_RECURSE ${WORK})
file(MAKE_DIRECTORY ${WORK})
set(project ${CMAKE_CURRENT_LIST_DIR}/project)

if(WAY STREQUAL copied_folder)
  file(COPY ${SOURCE}/include/lvsm DESTINATION ${WORK})
  run(${COMPILER} -std=c++17 -I${WORK} ${GLM} ${project}/main.cpp -o ${WORK}/consumer)
  run(${WORK}/consumer)
  return()
endif()

if(WAY STREQUAL find_package)
  # An installed package may be moved.
  run(${CMAKE_COMMAND} --install ${BUILT} --prefix ${WORK}/elsewhere)
  file(RENAME ${WORK}/elsewhere ${WORK}/prefix)
  set(way -DCMAKE_PREFIX_PATH=${WORK}/prefix)
else()
  set(way -DLVSM_SOURCE=${SOURCE})
endif()
run(${CMAKE_COMMAND} -S ${project} -B ${WORK}/build -G ${GENERATOR} -DCMAKE_CXX_COMPILER=${COMPILER} ${way})
run(${CMAKE_COMMAND} --build ${WORK}/build --target consumer)
run(${CMAKE_CTEST_COMMAND} --test-dir ${WORK}/build --output-on-failure --no-tests=error)
