# SPDX-License-Identifier: GPL-3.0-or-later
# patina_kernels(TARGET FILE...): compiles each GLSL file to SPIR-V and embeds it as `const uint32_t <stem>_spv[]`,
# included as "kernels/<stem>.h". Headers a kernel includes are tracked, so editing one rebuilds both sides.
# Stems are unique over all targets.
find_program(GLSLANG glslangValidator REQUIRED)
find_program(SPIRV_VAL spirv-val REQUIRED)

function(patina_kernels target)
  set(embedded)
  set(spv_dir ${CMAKE_BINARY_DIR}/kernels/spv)
  set(include_dir ${CMAKE_BINARY_DIR}/kernels/include)
  file(MAKE_DIRECTORY ${spv_dir} ${include_dir}/kernels)
  foreach(file ${ARGN})
    get_filename_component(stem ${file} NAME_WE)
    get_filename_component(source ${file} ABSOLUTE)
    get_property(stems GLOBAL PROPERTY PATINA_KERNEL_STEMS)
    if(stem IN_LIST stems)
      message(FATAL_ERROR "Two kernels are called ${stem}; the second is ${source}.")
    endif()
    set_property(GLOBAL APPEND PROPERTY PATINA_KERNEL_STEMS ${stem})
    set(spv ${spv_dir}/${stem}.spv)
    set(words ${spv_dir}/${stem}.words)
    add_custom_command(
      OUTPUT ${words} ${spv}
      COMMAND ${GLSLANG} --quiet -V --target-env vulkan1.1 -g -I${PROJECT_SOURCE_DIR} --depfile ${spv}.d -o ${spv} ${source}
      COMMAND ${SPIRV_VAL} --target-env vulkan1.1 ${spv}
      COMMAND ${GLSLANG} --quiet -V --target-env vulkan1.1 -g -I${PROJECT_SOURCE_DIR} --vn ${stem}_spv -o ${words} ${source}
      DEPENDS ${source}
      DEPFILE ${spv}.d
      COMMENT "Kernel ${stem}"
      VERBATIM)
    # glslang's output has neither an include guard nor the include it needs.
    file(CONFIGURE OUTPUT ${include_dir}/kernels/${stem}.h
      CONTENT "#pragma once\n\n#include <stdint.h>\n\n#include \"../../spv/${stem}.words\"\n")
    list(APPEND embedded ${words})
  endforeach()
  add_custom_target(${target}_spirv DEPENDS ${embedded})
  add_library(${target} INTERFACE)
  add_dependencies(${target} ${target}_spirv)
  target_include_directories(${target} INTERFACE ${include_dir})
endfunction()

# patina_kernel_texts(TARGET FILE...): embeds the preprocessed text of kernels of TARGET as `const char* <stem>_text`,
# included as "kernels/<stem>_text.h", so that they can be compiled again with BRDFs written by the user.
function(patina_kernel_texts target)
  set(script ${PROJECT_SOURCE_DIR}/cmake/kernel_text.cmake)
  set(headers)
  foreach(file ${ARGN})
    get_filename_component(stem ${file} NAME_WE)
    get_filename_component(source ${file} ABSOLUTE)
    set(header ${CMAKE_BINARY_DIR}/kernels/include/kernels/${stem}_text.h)
    # Depends on the kernel's words, which are rebuilt whenever a header it includes changes.
    add_custom_command(
      OUTPUT ${header}
      COMMAND ${CMAKE_COMMAND} -DGLSLANG=${GLSLANG} -DSOURCE=${source} -DINCLUDE_DIR=${PROJECT_SOURCE_DIR} -DNAME=${stem}
        -DOUTPUT=${header} -P ${script}
      DEPENDS ${script} ${source} ${CMAKE_BINARY_DIR}/kernels/spv/${stem}.words
      COMMENT "Text of kernel ${stem}"
      VERBATIM)
    list(APPEND headers ${header})
  endforeach()
  add_custom_target(${target}_texts DEPENDS ${headers})
  add_dependencies(${target} ${target}_texts)
endfunction()
