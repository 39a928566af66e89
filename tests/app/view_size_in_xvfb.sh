#!/usr/bin/env bash
# view_size_in_xvfb.sh PROGRAM FOLDER: opens scene.sdf of the folder in a window that is to be larger than any display.
# Succeeds if it is as large as its own display, 400x300, and closes when told so. Leaves log.txt.
set -u
program=$1
# shellcheck source-path=SCRIPTDIR source=../support/xvfb_window.sh
source "$(dirname "${BASH_SOURCE[0]}")/../support/xvfb_window.sh"
cd "$2" || exit 1

start_display 400x300
"$program" view scene.sdf --size 100000x100000 >out.txt 2>log.txt &
window=$!
await_window scene.sdf 400x300
is_fitted() { xdotool getwindowgeometry "$id" | grep -q 'Geometry: 400x300'; }
until_true is_fitted || exit 1
press q
wait $window
