# Builds and runs a project against the library, taken in one way:
#   cmake -D WAY=... -D SOURCE=... -D BUILT=... -D WORK=... -D COMPILER=... -D GENERATOR=... -D GLM=... -P consume.cmake
# WAY: a function of this file. SOURCE: this repository. BUILT: its build folder. WORK: a folder of this test's own.
# GLM: GLM's include folder.
cmake_minimum_required(VERSION 3.22)

function(run)
  execute_process(COMMAND ${ARGN} COMMAND_ECHO STDOUT COMMAND_ERROR_IS_FATAL ANY)
endfunction()

# build(PROJECT OPTION...): configures, builds and tests a project that stands beside this file.
function(build project)
  run(${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR}/${project} -B ${WORK}/build -G ${GENERATOR}
    -DCMAKE_CXX_COMPILER=${COMPILER} -DGLM_FOLDER=${GLM} ${ARGN})
  run(${CMAKE_COMMAND} --build ${WORK}/build)
  run(${CMAKE_CTEST_COMMAND} --test-dir ${WORK}/build --output-on-failure --no-tests=error)
endfunction()

# An installed package may be moved.
function(install_and_move build)
  run(${CMAKE_COMMAND} --install ${build} --prefix ${WORK}/elsewhere)
  file(RENAME ${WORK}/elsewhere ${WORK}/prefix)
endfunction()

function(compile)
  run(${COMPILER} -std=c++17 ${CMAKE_CURRENT_LIST_DIR}/project/main.cpp ${ARGN} -o ${WORK}/consumer)
endfunction()

function(copied_folder)
  file(COPY ${SOURCE}/include/lvsm DESTINATION ${WORK})
  if(NOT GLM STREQUAL /usr/include) # the compilers know it, and must not be told again
    set(glm_flag -isystem${GLM})
  endif()
  compile(-I${WORK} ${glm_flag})
  run(${WORK}/consumer)
endfunction()

# What a package holds: all headers and shader files, one-file versions of the maths, wrappers and passes, and lvsm.mjs where
# this machine can make it.
function(check_files prefix)
  file(GLOB_RECURSE headers RELATIVE ${SOURCE} ${SOURCE}/include/lvsm/*)
  file(GLOB_RECURSE shaders RELATIVE ${SOURCE} ${SOURCE}/glsl/lvsm/* ${SOURCE}/hlsl/lvsm/* ${SOURCE}/wgsl/lvsm/*)
  list(TRANSFORM shaders PREPEND share/lvsm/)
  set(files share/doc/lvsm/LICENSE ${headers} ${shaders})
  foreach(file all.glsl all.hlsli all.wgsl combined.glsl separate.glsl separate.hlsli separate.wgsl)
    list(APPEND files share/lvsm/single/lvsm_${file})
  endforeach()
  foreach(pass store blur mip fused mixture place)
    list(APPEND files share/lvsm/single/lvsm_${pass}.comp share/lvsm/single/lvsm_${pass}.hlsl)
  endforeach()
  foreach(pass store blur mip fused place step_sums step_move)
    list(APPEND files share/lvsm/single/lvsm_${pass}.wgsl)
  endforeach()
  foreach(pass store blur mip mixture step_sums step_move)
    list(APPEND files share/lvsm/single/lvsm_${pass}.frag)
  endforeach()
  if(EXISTS ${BUILT}/wasm/lvsm.mjs)
    list(APPEND files share/lvsm/host/lvsm.mjs share/lvsm/host/lvsm.d.mts)
  endif()
  foreach(file ${files})
    if(NOT EXISTS ${prefix}/${file})
      message(FATAL_ERROR "the package lacks ${file}")
    endif()
  endforeach()
endfunction()

function(find_package_of_an_installation)
  install_and_move(${BUILT})
  check_files(${WORK}/prefix)
  build(project -DCMAKE_PREFIX_PATH=${WORK}/prefix)
endfunction()

function(find_package_where_glm_is_a_target)
  install_and_move(${BUILT})
  build(parent -DCMAKE_PREFIX_PATH=${WORK}/prefix)
endfunction()

function(subproject)
  build(project -DLVSM_SOURCE=${SOURCE})
endfunction()

function(subproject_beside_glm)
  build(parent -DLVSM_SOURCE=${SOURCE})
endfunction()

function(subproject_installs_nothing)
  build(parent -DLVSM_SOURCE=${SOURCE})
  run(${CMAKE_COMMAND} --install ${WORK}/build --prefix ${WORK}/prefix)
  file(GLOB_RECURSE installed RELATIVE ${WORK}/prefix ${WORK}/prefix/*)
  if(NOT installed STREQUAL bin/consumer)
    message(FATAL_ERROR "the parent installs more than its own program: ${installed}")
  endif()
endfunction()

function(subproject_installs_when_asked)
  build(parent -DLVSM_SOURCE=${SOURCE} -DLVSM_INSTALL=ON)
  install_and_move(${WORK}/build)
  file(RENAME ${WORK}/build ${WORK}/build-of-parent)
  build(project -DCMAKE_PREFIX_PATH=${WORK}/prefix)
endfunction()

function(fetch_content)
  find_program(GIT git REQUIRED)
  file(COPY ${SOURCE}/CMakeLists.txt ${SOURCE}/LICENSE ${SOURCE}/cmake ${SOURCE}/include ${SOURCE}/glsl ${SOURCE}/hlsl
    DESTINATION ${WORK}/repository)
  set(git ${GIT} -C ${WORK}/repository -c user.name=test -c user.email=test@localhost)
  run(${git} init -q)
  run(${git} add .)
  run(${git} commit -q -m "lvsm")
  run(${git} tag v0.1)
  build(fetch -DLVSM_REPOSITORY=file://${WORK}/repository)
endfunction()

function(pkg_config)
  find_program(PKG_CONFIG pkg-config REQUIRED)
  install_and_move(${BUILT})
  set(ENV{PKG_CONFIG_PATH} ${WORK}/prefix/share/pkgconfig)
  run(${PKG_CONFIG} --exists "lvsm >= 0.1")
  foreach(variable glsldir hlsldir wgsldir singledir)
    execute_process(COMMAND ${PKG_CONFIG} --variable=${variable} lvsm
      OUTPUT_VARIABLE ${variable} OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
  endforeach()
  execute_process(COMMAND ${PKG_CONFIG} --cflags lvsm OUTPUT_VARIABLE flags COMMAND_ERROR_IS_FATAL ANY)
  separate_arguments(flags UNIX_COMMAND "${flags}")
  compile(${flags})
  run(${WORK}/consumer ${glsldir}/lvsm/lvsm.glsl ${hlsldir}/lvsm/lvsm.hlsli ${wgsldir}/lvsm/lvsm.wgsl ${singledir}/lvsm_all.glsl)
endfunction()

# CMake finds the package in the archive of a release.
function(release)
  run(${CMAKE_COMMAND} -D FOLDER=${WORK}/release -P ${SOURCE}/cmake/release.cmake)
  file(GLOB archive ${WORK}/release/lvsm-*.zip)
  file(ARCHIVE_EXTRACT INPUT ${archive} DESTINATION ${WORK}/unpacked)
  file(GLOB prefix ${WORK}/unpacked/lvsm-*)
  check_files(${prefix})
  run(${CMAKE_COMMAND} -D SOURCE=${prefix}/share/lvsm/glsl/lvsm/bracket.glsl -D OUTPUT=${WORK}/lvsm_bracket.glsl
    -P ${prefix}/share/lvsm/cmake/single_file.cmake)
  build(project -DCMAKE_PREFIX_PATH=${prefix})
endfunction()

file(REMOVE_RECURSE ${WORK})
file(MAKE_DIRECTORY ${WORK})
cmake_language(CALL ${WAY})
