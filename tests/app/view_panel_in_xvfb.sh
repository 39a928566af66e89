#!/usr/bin/env bash
# view_panel_in_xvfb.sh PROGRAM FOLDER: opens scene.sdf of the folder in a window of 640x480 on a display of its own and
# uses the panel as a user would. Leaves the pictures there that view_panel_test.cpp looks at, log.txt, and exit_code.
set -u
program=$1
# shellcheck source-path=SCRIPTDIR source=../support/xvfb_window.sh
source "$(dirname "${BASH_SOURCE[0]}")/../support/xvfb_window.sh"
cd "$2" || exit 1

start_display 800x600
"$program" view scene.sdf --size 640x480 >out.txt 2>log.txt &
window=$!
await_window scene.sdf 640x480

until_true drawn opened.png || exit 1
click 511 240 # the ball
until_true changed picked.png opened.png || exit 1
click 600 470 # nothing
until_true changed nothing.png picked.png || exit 1
click 25 87 # the arrow of the first row in the tree
until_true changed unfolded.png nothing.png || exit 1
click 62 87 # the row itself
until_true changed chosen.png unfolded.png || exit 1
click 600 470
until_true changed again.png chosen.png || exit 1
click 92 247 # the lights
click 52 267  # the first of them
until_true changed lights.png again.png || exit 1
click 31 287 # its brightness: none
until_true changed dark.png lights.png || exit 1
click 47 354 # reset
until_true changed reset.png dark.png || exit 1
click 118 354 # copy
has_light() { grep -q 'define light' out.txt; }
until_true has_light || exit 1
click 115 10 # the menu of help
until_true changed menu.png reset.png || exit 1
click 150 32 # its only entry: the keys
until_true changed keys.png menu.png || exit 1
click 115 10
until_true changed menu_again.png keys.png || exit 1
click 150 32
until_true changed closed.png keys.png || exit 1
# Escape closes what lies over the picture, and not yet the window.
click 115 10
until_true changed menu_open.png closed.png || exit 1
press Escape
until_true changed menu_closed.png menu_open.png || exit 1
press question
until_true changed keys_open.png menu_closed.png || exit 1
press Escape
until_true changed keys_closed.png keys_open.png || exit 1
press d
until_true changed depth.png reset.png || exit 1
press n
until_true changed normal.png depth.png || exit 1
press o
until_true changed object.png normal.png || exit 1
press p
until_true changed picture.png object.png || exit 1
before=picture.png
for overlay in g x e; do
  press $overlay
  until_true changed overlay_$overlay.png "$before" || exit 1
  press $overlay
  until_true changed without_$overlay.png overlay_$overlay.png || exit 1
  before=without_$overlay.png
done
click 92 390 # the materials
click 52 410  # the only one
until_true changed materials.png "$before" || exit 1
drag 52 452 2 452 # the red of its kd, by 50 of 255
until_true changed material.png materials.png || exit 1
press Escape # is told that this would be lost
until_true changed unsaved.png material.png || exit 1
press w
has_scene() { [[ -s scene_edited_0001.sdf ]]; }
until_true has_scene || exit 1
click 92 390 # the materials are folded up
click 92 413 # the picture
until_true changed development.png material.png || exit 1
click 17 436 # its exposure: the least
until_true changed underexposed.png development.png || exit 1
press q
wait $window
echo $? >exit_code
