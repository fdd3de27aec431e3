# SPDX-License-Identifier: GPL-3.0-or-later
# patina_check_headers(TARGET...): adds the target `check_headers`, which compiles every public header of the targets alone.
# CMake's own all_verify_interface_header_sets does the same at three times the cost, because it parses Eigen and TBB
# again for each header.
function(patina_check_headers)
  add_custom_target(check_headers)
  foreach(target ${ARGN})
    get_target_property(headers ${target} HEADER_SET)
    set(sources)
    foreach(header ${headers})
      file(RELATIVE_PATH path ${PROJECT_SOURCE_DIR} ${header})
      set(source ${CMAKE_BINARY_DIR}/headers/${path}.cpp)
      file(CONFIGURE OUTPUT ${source} CONTENT "#include \"${path}\"\n")
      list(APPEND sources ${source})
    endforeach()
    add_library(${target}_headers OBJECT EXCLUDE_FROM_ALL ${sources})
    target_link_libraries(${target}_headers PRIVATE ${target})
    # Without optimisation and debug information, since nothing is kept of the objects.
    target_compile_options(${target}_headers PRIVATE -O0 -g0)
    set_target_properties(${target}_headers PROPERTIES UNITY_BUILD OFF)
    if(target MATCHES "^(core|render|ui)$")
      target_precompile_headers(${target}_headers PRIVATE <Eigen/Geometry> <tbb/parallel_for.h>)
    endif()
    add_dependencies(check_headers ${target}_headers)
  endforeach()
endfunction()
