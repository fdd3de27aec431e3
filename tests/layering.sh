#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Includes point down only: app -> ui -> core/render -> {core, gpu}; core and gpu never see each other.
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

mapfile -t core_files < <(find core -type f -not -path "core/render/*")
forbid 'core must not see gpu, Vulkan, the renderer, ui or app.' 'gpu/|vulkan|core/render/|ui/|app/' "${core_files[@]}"
forbid 'core and gpu must not see Qt.' 'Q[A-Z]|Qt' core gpu
forbid 'gpu must not see anything above it.' 'core/|ui/|app/' gpu
forbid 'core/render must not see ui or app.' 'ui/|app/' core/render
forbid 'ui must not see app.' 'app/' ui
exit $status
