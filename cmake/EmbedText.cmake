# Compiles text files into a library, so that it needs no data folder at run time.
#
#   include(EmbedText)
#   haarlight_embed_text(<target> <name> <file>...)
#
# e.g. `haarlight_embed_text(haarlight_core kernels shade.cl blur.cl)` gives the sources of <target>
#
#   #include "embedded/kernels.h"
#   std::string_view source = haarlight::embedded::kernels("shade.cl");
#
# Texts are found by their file names without folders, which must differ; any other name gives an
# empty view whose data() is null. Files may hold any bytes, and data() is terminated by a zero.
# A text whose name ends in .cl begins with a line `#line 1 "<file name>"`, so that the messages of
# an OpenCL compiler name the file. A file that is edited is embedded again by the next build.
#
# The file is also the script that the build runs:
#   cmake -P EmbedText.cmake <name> <output> <file>...

function(haarlight_embed_text target name)
  set(folder ${CMAKE_CURRENT_BINARY_DIR}/generated)
  set(source ${folder}/embedded/${name}.cpp)
  set(files)
  set(file_names)
  foreach(file IN LISTS ARGN)
    cmake_path(ABSOLUTE_PATH file BASE_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR} NORMALIZE)
    cmake_path(GET file FILENAME file_name)
    if(file_name IN_LIST file_names)
      message(FATAL_ERROR "haarlight_embed_text: two files of ${name} have the name ${file_name}")
    endif()
    list(APPEND files ${file})
    list(APPEND file_names ${file_name})
  endforeach()
  list(JOIN file_names " " file_names)

  file(CONFIGURE OUTPUT ${folder}/embedded/${name}.h @ONLY CONTENT [[
#pragma once

#include <string_view>

namespace haarlight::embedded {

/// The text of one of these files:
///   @file_names@
/// For any other name the view's data() is null.
std::string_view @name@(std::string_view fileName);

}  // namespace haarlight::embedded
]])
  add_custom_command(
    OUTPUT ${source}
    COMMAND ${CMAKE_COMMAND} -P ${CMAKE_CURRENT_FUNCTION_LIST_FILE} ${name} ${source} ${files}
    DEPENDS ${files} ${CMAKE_CURRENT_FUNCTION_LIST_FILE}
    COMMENT "Embedding ${file_names}" VERBATIM)
  # <target> may belong to another folder, where only a target makes the command known.
  add_custom_target(${target}_embed_${name} DEPENDS ${source})
  add_dependencies(${target} ${target}_embed_${name})
  set_source_files_properties(${source} TARGET_DIRECTORY ${target} PROPERTIES GENERATED ON)
  target_sources(${target} PRIVATE ${source})
  target_include_directories(${target} PRIVATE ${folder})
endfunction()

# Sets `result` to the initialiser of a zero-terminated char array.
function(haarlight_char_array_initializer file result)
  file(READ ${file} bytes HEX)
  cmake_path(GET file FILENAME file_name)
  if(file_name MATCHES "\\.cl$")
    string(HEX "#line 1 \"${file_name}\"\n" first_line)
    string(PREPEND bytes ${first_line})
  endif()
  string(REGEX REPLACE "(..)" "'\\\\x\\1'," bytes "${bytes}")
  string(REPEAT "'.x..'," 14 line)
  string(REGEX REPLACE "(${line})" "\\1\n    " bytes "${bytes}")
  set(${result} "{\n    ${bytes}'\\0'}" PARENT_SCOPE)
endfunction()

function(haarlight_write_embedded_source name output)
  set(lookups "")
  set(arrays "")
  set(number 0)
  foreach(file IN LISTS ARGN)
    cmake_path(GET file FILENAME file_name)
    haarlight_char_array_initializer(${file} initializer)
    string(APPEND arrays "constexpr char text${number}[] = ${initializer};\n\n")
    string(APPEND lookups "  if (fileName == \"${file_name}\") "
                          "return {text${number}, sizeof text${number} - 1};\n")
    math(EXPR number "${number} + 1")
  endforeach()
  file(WRITE ${output} "#include \"embedded/${name}.h\"

namespace haarlight::embedded {

namespace {

${arrays}}  // namespace

std::string_view ${name}(std::string_view fileName) {
${lookups}  return {};
}

}  // namespace haarlight::embedded
")
endfunction()

if(CMAKE_SCRIPT_MODE_FILE STREQUAL CMAKE_CURRENT_LIST_FILE)
  cmake_policy(VERSION 3.25)
  set(arguments)
  math(EXPR last "${CMAKE_ARGC} - 1")
  foreach(index RANGE 3 ${last})  # after cmake -P <script>
    list(APPEND arguments ${CMAKE_ARGV${index}})
  endforeach()
  haarlight_write_embedded_source(${arguments})
endif()
