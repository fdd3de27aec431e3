# SPDX-License-Identifier: GPL-3.0-or-later
# Run by cmake -P: writes the preprocessed text of a kernel as a C++ header. Reads the variables GLSLANG, SOURCE,
# INCLUDE_DIR, NAME and OUTPUT.
execute_process(
  COMMAND ${GLSLANG} -E -DPATINA_USER_BRDFS -I${INCLUDE_DIR} ${SOURCE}
  OUTPUT_VARIABLE text RESULT_VARIABLE result ERROR_VARIABLE errors)
if(NOT result EQUAL 0)
  message(FATAL_ERROR "Preprocessing ${SOURCE} failed: ${errors}")
endif()
string(REGEX REPLACE "#line[^\n]*\n" "\n" text "${text}")
string(REGEX REPLACE "#extension GL_GOOGLE_include_directive[^\n]*\n" "\n" text "${text}")
string(REGEX REPLACE "\n[ \t\n]*\n" "\n" text "${text}")
file(WRITE ${OUTPUT} "#pragma once\n\ninline constexpr const char* ${NAME}_text = R\"glsl(${text})glsl\";\n")
