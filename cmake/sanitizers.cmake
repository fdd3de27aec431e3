# SPDX-License-Identifier: GPL-3.0-or-later
if(PATINA_SANITIZE)
  target_compile_options(patina_options INTERFACE -fsanitize=${PATINA_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  target_link_options(patina_options INTERFACE -fsanitize=${PATINA_SANITIZE})
endif()
