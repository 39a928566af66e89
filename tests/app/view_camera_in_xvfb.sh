#!/usr/bin/env bash
# view_camera_in_xvfb.sh PROGRAM FOLDER: opens scene.sdf of the folder in a square window on a display of its own, makes it
# wide, and has everything framed. Leaves there: square.png, wide.png, framed.png, exit_code, and log.txt.
set -u
program=$1
# shellcheck source-path=SCRIPTDIR source=../support/xvfb_window.sh
source "$(dirname "${BASH_SOURCE[0]}")/../support/xvfb_window.sh"
cd "$2" || exit 1

start_display 600x300
"$program" view scene.sdf --size 240x240 >out.txt 2>log.txt &
window=$!
await_window scene.sdf 240x240
press Tab
until_true drawn square.png || exit 1
xdotool windowsize --sync "$id" 480 240
window_size=480x240
until_true changed wide.png square.png || exit 1
press f
until_true changed framed.png wide.png || exit 1
press q
wait $window
echo $? >exit_code
