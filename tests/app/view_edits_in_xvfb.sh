#!/usr/bin/env bash
# view_edits_in_xvfb.sh PROGRAM FOLDER: opens scene.sdf of the folder in a window of 640x480 on a display of its own, changes
# its material, and goes on to another file, changes that, and closes the window by its button. Each takes two times, and
# the first leaves a picture there: told_of_step.png and told_of_close.png. Also: changed.png, which they differ from,
# log.txt, and exit_code.
set -u
program=$1
# shellcheck source-path=SCRIPTDIR source=../support/xvfb_window.sh
source "$(dirname "${BASH_SOURCE[0]}")/../support/xvfb_window.sh"
support=$(realpath "$(dirname "${BASH_SOURCE[0]}")/../support")
cd "$2" || exit 1

shows() { xdotool search --name "^lichtraum - $1\$" >/dev/null; }
press_close_button() { python3 "$support/close_window.py" "$id"; }

start_display 800x600
"$program" view scene.sdf --size 640x480 --samples 1 >out.txt 2>log.txt &
window=$!
await_window scene.sdf 640x480
until_true drawn opened.png || exit 1
click 92 270 # the materials
until_true changed materials.png opened.png || exit 1
click 52 290 # the only one
until_true changed material.png materials.png || exit 1
drag 52 332 2 332 # the red of its kd
until_true changed changed.png material.png || exit 1
press Page_Down
until_true changed told_of_step.png changed.png || exit 1
shows scene.sdf || exit 1
press Page_Down
until_true shows second.sdf || exit 1
until_true drawn second.png || exit 1
drag 52 332 2 332
until_true changed changed_again.png second.png || exit 1
press_close_button
until_true changed told_of_close.png changed_again.png || exit 1
press_close_button
wait $window
echo $? >exit_code
