#!/usr/bin/env bash
# view_labels_in_xvfb.sh PROGRAM FOLDER: opens model.gltf of the folder in a window of 900x1000 on a display of its own and
# unfolds its material. Leaves pictures there: material.png, and told.png, with the mouse on a label that is cut off.
set -u
program=$1
# shellcheck source-path=SCRIPTDIR source=../support/xvfb_window.sh
source "$(dirname "${BASH_SOURCE[0]}")/../support/xvfb_window.sh"
cd "$2" || exit 1

start_display 1000x1100
"$program" view model.gltf --size 900x1000 --samples 1 >out.txt 2>log.txt &
window=$!
await_window model.gltf 900x1000
until_true drawn opened.png || exit 1
click 92 404 # the materials
until_true changed materials.png opened.png || exit 1
click 52 424 # the only one
until_true changed material.png materials.png || exit 1
xdotool mousemove $((X + 190)) $((Y + 858)) # its diffuse transmission color
until_true changed told.png material.png || exit 1
press q
wait $window
