# SPDX-License-Identifier: GPL-3.0-or-later
# patina_kernels(TARGET FILE...): compiles each GLSL file to SPIR-V and embeds it as `const uint32_t <stem>_spv[]`,
# included as "kernels/<stem>.h". Headers a kernel includes are tracked, so editing one rebuilds both sides.
find_program(GLSLANG glslangValidator REQUIRED)
find_program(SPIRV_VAL spirv-val REQUIRED)

function(patina_kernels target)
  set(headers)
  foreach(file ${ARGN})
    get_filename_component(stem ${file} NAME_WE)
    get_filename_component(source ${file} ABSOLUTE)
    set(spv ${CMAKE_BINARY_DIR}/kernels/spv/${stem}.spv)
    set(header ${CMAKE_BINARY_DIR}/kernels/include/kernels/${stem}.h)
    file(MAKE_DIRECTORY ${CMAKE_BINARY_DIR}/kernels/spv ${CMAKE_BINARY_DIR}/kernels/include/kernels)
    add_custom_command(
      OUTPUT ${header} ${spv}
      COMMAND ${GLSLANG} --quiet -V --target-env vulkan1.1 -g -I${PROJECT_SOURCE_DIR} --depfile ${spv}.d -o ${spv} ${source}
      COMMAND ${SPIRV_VAL} --target-env vulkan1.1 ${spv}
      COMMAND ${GLSLANG} --quiet -V --target-env vulkan1.1 -g -I${PROJECT_SOURCE_DIR} --vn ${stem}_spv -o ${header} ${source}
      DEPENDS ${source}
      DEPFILE ${spv}.d
      COMMENT "Kernel ${stem}"
      VERBATIM)
    list(APPEND headers ${header})
  endforeach()
  add_custom_target(${target}_spirv DEPENDS ${headers})
  add_library(${target} INTERFACE)
  add_dependencies(${target} ${target}_spirv)
  target_include_directories(${target} INTERFACE ${CMAKE_BINARY_DIR}/kernels/include)
endfunction()
