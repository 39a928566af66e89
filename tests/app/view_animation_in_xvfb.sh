#!/usr/bin/env bash
# view_animation_in_xvfb.sh PROGRAM FOLDER: opens moving.glb of the folder in a window of 640x480 on a display of its own,
# plays its animation, goes through its frames, and puts smaller.glb in its place. Leaves the pictures there that view_animation_test.cpp looks at, log.txt,
# and exit_code.
set -u
program=$1
# shellcheck source-path=SCRIPTDIR source=../support/xvfb_window.sh
source "$(dirname "${BASH_SOURCE[0]}")/../support/xvfb_window.sh"
cd "$2" || exit 1

start_display 800x600
"$program" view moving.glb --watch --size 640x480 --integrator whitted --samples 1 >out.txt 2>log.txt &
window=$!
await_window moving.glb 640x480

until_true drawn opened.png || exit 1
press Home
until_true changed start.png opened.png || exit 1
for ((i = 0; i < 10; ++i)); do press Right; done
until_true changed stepped.png start.png || exit 1
press Left
until_true changed back.png stepped.png || exit 1
press Home
until_true same start_again.png start.png || exit 1
kill -STOP $window # as a busy machine may stop it, until Shift is let go of
press shift+Right
kill -CONT $window
until_true changed turned.png start.png || exit 1
press r
until_true same straight.png start.png || exit 1
click 65 10 # the menu of views
until_true changed menu.png straight.png || exit 1
click 85 119 # to the right
until_true same turned_by_menu.png turned.png || exit 1
press r
until_true same straight.png start.png || exit 1
press space
has_moved() { shot playing.png && ! cmp -s playing.png straight.png; }
until_true has_moved || exit 1
cp playing.png first.png
has_moved_on() { shot playing.png && ! cmp -s playing.png first.png; }
until_true has_moved_on || exit 1
press space
until_true settled paused.png || exit 1
click 600 456 # on the time line, near its end
until_true changed late.png paused.png || exit 1
click 92 294 # the picture's sliders
until_true changed sliders.png late.png || exit 1
click 100 340 # the lens's aperture
until_true changed lens.png sliders.png || exit 1
press Left
until_true changed lens_before.png lens.png || exit 1
cp smaller.glb moving.glb
until_true changed smaller.png lens_before.png || exit 1
press w # is told that there is nothing to be saved
until_true changed told.png smaller.png || exit 1
press q
wait $window
echo $? >exit_code
