#!/usr/bin/env bash
# view_typing_in_xvfb.sh PROGRAM FOLDER: opens lit.sdf of the folder in a window of 640x480 on a display of its own, types
# 0.5 as the red of its lamp's colour, and copies the lamp. Leaves that in out.txt.
set -u
program=$1
# shellcheck source-path=SCRIPTDIR source=../support/xvfb_window.sh
source "$(dirname "${BASH_SOURCE[0]}")/../support/xvfb_window.sh"
cd "$2" || exit 1

start_display 800x600
"$program" view lit.sdf --size 640x480 --samples 1 >out.txt 2>log.txt &
window=$!
await_window lit.sdf 640x480
until_true drawn opened.png || exit 1
click 92 247 # the lights
until_true changed folded.png opened.png || exit 1
click 52 267 # the first of them
until_true changed lamp.png folded.png || exit 1
xdotool keydown ctrl
click 48 310 # its red
xdotool keyup ctrl
is_typing() { shot typing.png && ! cmp -s typing.png lamp.png; }
until_true is_typing || exit 1
xdotool type --delay 200 0.5
xdotool key Return
is_copied() { click 118 354 && grep -q 'define light' out.txt; }
until_true is_copied || exit 1
