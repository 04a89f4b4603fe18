# Joins SOURCE and all that it includes into one file, OUTPUT, for pipelines that have no #include: all topics, or one
# with what it needs, or a pass.
#   cmake -D SOURCE=glsl/lvsm/lvsm.glsl -D OUTPUT=lvsm_all.glsl -P cmake/single_file.cmake
#   cmake -D SOURCE=glsl/lvsm/bracket.glsl -D OUTPUT=lvsm_bracket.glsl -P cmake/single_file.cmake
# An include is looked up as a compiler does it: beside the including file, then in the folder that holds lvsm/.
# A file is put in once, where it is first included; its guard stays, so a client may still mix both forms.
cmake_minimum_required(VERSION 3.22)

get_filename_component(name ${OUTPUT} NAME)
get_filename_component(folder ${SOURCE} DIRECTORY)
get_filename_component(root ${folder} DIRECTORY)

# Appends to `joined` (of the caller's scope) the text of `file` with its includes resolved.
function(join file)
  cmake_path(ABSOLUTE_PATH file NORMALIZE)
  if(file IN_LIST seen)
    return()
  endif()
  list(APPEND seen ${file})
  file(READ ${file} rest)
  string(REPLACE "${notice}" "" rest "${rest}")
  string(REGEX REPLACE "// Needs: [^\n]*\n" "" rest "${rest}")
  string(REPLACE "#extension GL_GOOGLE_include_directive : require\n" "" rest "${rest}")
  get_filename_component(beside ${file} DIRECTORY)
  while(rest MATCHES "\n[ \t]*#[ \t]*include[ \t]+[\"<]([^\">]+)[\">][^\n]*")
    set(line "${CMAKE_MATCH_0}")
    set(included "${CMAKE_MATCH_1}")
    string(FIND "${rest}" "${line}" position)
    string(SUBSTRING "${rest}" 0 ${position} before)
    string(LENGTH "${line}" length)
    math(EXPR position "${position} + ${length}")
    string(SUBSTRING "${rest}" ${position} -1 rest)
    string(APPEND joined "${before}\n")
    if(EXISTS ${beside}/${included})
      join(${beside}/${included})
    elseif(EXISTS ${root}/${included})
      join(${root}/${included})
    else()
      message(FATAL_ERROR "${file} includes ${included}, which is neither beside it nor in ${root}")
    endif()
  endwhile()
  set(joined "${joined}${rest}" PARENT_SCOPE)
  set(seen ${seen} PARENT_SCOPE)
endfunction()

# The licence's notice stands once, at the top.
set(notice "// SPDX-License-Identifier: MIT\n// Copyright (c) 2026 lvsm contributors\n")
get_filename_component(source ${SOURCE} NAME)
set(joined "${notice}// ${name}: lvsm's ${source} and all that it includes, joined. Paste it as it is, or include it.\n")
set(seen "")
join(${SOURCE})
# What the manual includes is this file.
string(REPLACE "#include \"lvsm/${source}\"" "#include \"${name}\"" joined "${joined}")
# Compilers want #version first.
if(joined MATCHES "\n(#version[^\n]*\n)")
  set(version "${CMAKE_MATCH_1}")
  string(REPLACE "${version}" "" joined "${joined}")
  set(joined "${version}${joined}")
endif()
file(WRITE ${OUTPUT} "${joined}")
