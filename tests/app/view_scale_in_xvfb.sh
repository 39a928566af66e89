#!/usr/bin/env bash
# view_scale_in_xvfb.sh PROGRAM FOLDER: opens scene.sdf of the folder at twice the usual scale, in a window of twice 640x480,
# and clicks on the first row of the tree. Leaves opened.png and chosen.png there.
set -u
program=$1
# shellcheck source-path=SCRIPTDIR source=../support/xvfb_window.sh
source "$(dirname "${BASH_SOURCE[0]}")/../support/xvfb_window.sh"
cd "$2" || exit 1

start_display 1400x1000
"$program" view scene.sdf --size 1280x960 --ui-scale 2 --samples 1 >out.txt 2>log.txt &
window=$!
await_window scene.sdf 1280x960
until_true drawn opened.png || exit 1
click 124 174
until_true changed chosen.png opened.png || exit 1
press q
wait $window
