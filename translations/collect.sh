#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# collect.sh LUPDATE FILE.ts...: brings the files up to date with the texts in the sources. Run in the source folder.
set -eu
lupdate=$1
shift
aliases='QT_TRANSLATE_NOOP+=PARAM_LABEL,QT_TRANSLATE_NOOP+=MESSAGE_TEXT,QT_TRANSLATE_NOOP+=Message'
exec "$lupdate" -silent -locations none -no-obsolete -tr-function-alias "$aliases" \
    ui app/patina.cpp core render shaders/brdf -I . -ts "$@"
