#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Includes point down only, between the targets: app -> ui -> render -> {core, gpu}, where core and gpu never see each
# other; and between the rooms of core: base < material < scene < geometry < selection < analysis < shading, with io above analysis.
set -u
cd "$(dirname "$0")/.."
status=0

forbid() { # WHAT PATTERN PATH...
    local what=$1 pattern=$2
    shift 2
    local hits
    hits=$(grep -rnE --include='*.h' --include='*.cpp' "#include *[<\"]($pattern)" "$@") || return 0
    printf 'Layering: %s\n%s\n' "$what" "$hits" >&2
    status=1
}

forbid 'core must not see gpu, Vulkan, the renderer, ui or app.' 'gpu/|vulkan|render/|ui/|app/' core
forbid 'core, gpu and render must not see Qt.' 'Q[A-Z]|Qt' core gpu render
forbid 'gpu must not see anything above it.' 'core/|render/|ui/|app/' gpu
forbid 'render must not see ui or app.' 'ui/|app/' render
forbid 'ui must not see app.' 'app/' ui

rooms=(base material scene geometry selection analysis shading)
for ((i = 0; i < ${#rooms[@]}; ++i)); do
    above=$(IFS='|'; echo "${rooms[*]:i+1}")
    forbid "core/${rooms[i]} must not see a room above it." "core/(${above:+$above|}io)/" "core/${rooms[i]}"
done
forbid 'core/io must not see shading.' 'core/shading/' core/io
exit $status
