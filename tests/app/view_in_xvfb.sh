#!/usr/bin/env bash
# view_in_xvfb.sh PROGRAM FOLDER: opens scene.sdf of the folder in a window on a display of its own, and does what a user
# would; then draws it with --show. Leaves there: opened.png, turned.png, untold.png, saved.png, faulty.png, dismissed.png,
# camera.sdf, exit_code, then written.png, shown.png, exit_code_shown, and log.txt. In class: the windows that desktops take
# for lichtraum's.
set -u
program=$1
# shellcheck source-path=SCRIPTDIR source=../support/xvfb_window.sh
source "$(dirname "${BASH_SOURCE[0]}")/../support/xvfb_window.sh"
cd "$2" || exit 1

start_display 400x300
"$program" view scene.sdf --watch --size 320x240 >camera.sdf 2>log.txt &
window=$!
await_window scene.sdf 320x240
xdotool search --class '^lichtraum$' >class
press Tab # the numbers change all the time
until_true drawn opened.png || exit 1
press Right Right Right Up
until_true changed turned.png opened.png || exit 1
press c
has_camera() { grep -q translate camera.sdf; }
until_true has_camera || exit 1
until_true changed copied.png turned.png || exit 1 # it says so
press question
until_true changed keys.png copied.png || exit 1
press question
until_true changed without_keys.png keys.png || exit 1
xdotool keydown s
sleep 1.5 # long enough to be repeated
xdotool keyup s
has_picture() { [[ -s scene_view_0001.png ]]; }
until_true has_picture || exit 1
until_true changed told.png turned.png || exit 1 # it says so
press Shift_L                                    # a key without effect, but that it takes the message away
until_true changed untold.png told.png || exit 1
sed -i 's/material red .*/material red 0 0 0  0 0.6 0  0 0 0  1/' scene.sdf
until_true changed saved.png untold.png || exit 1
echo 'define nonsense' >>scene.sdf
until_true changed faulty.png saved.png || exit 1
press Shift_L
until_true changed dismissed.png faulty.png || exit 1
press q
wait $window
echo $? >exit_code

sed -i '$d' scene.sdf
"$program" render -q scene.sdf -o written.png --samples 2x2 --size 320x240 --show 2>>log.txt &
window=$!
await_window scene.sdf 320x240
press Tab
until_true drawn shown.png || exit 1
press q
wait $window
echo $? >exit_code_shown
