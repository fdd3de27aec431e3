# SPDX-License-Identifier: GPL-3.0-or-later
# Options of every target: warnings are errors, includes start at the repository root.
add_library(patina_options INTERFACE)
target_compile_options(patina_options INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Werror)
target_include_directories(patina_options INTERFACE ${PROJECT_SOURCE_DIR})
target_compile_definitions(patina_options INTERFACE PATINA_VERSION="${PROJECT_VERSION}"
  $<$<BOOL:${PATINA_ASSERTS}>:PATINA_ASSERTS>)
if(PATINA_UNITY)
  # The warning mistakes every source of a unity file for a header whose unnamed namespace other files would see.
  target_compile_options(patina_options INTERFACE -Wno-subobject-linkage)
endif()
