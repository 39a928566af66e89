#!/usr/bin/env bash
# view_resize_in_xvfb.sh PROGRAM FOLDER: opens scene.sdf of the folder and resizes its window faster than it can follow.
# Succeeds if the window is there after that, and closes when told so.
set -u
program=$1
# shellcheck source-path=SCRIPTDIR source=../support/xvfb_window.sh
source "$(dirname "${BASH_SOURCE[0]}")/../support/xvfb_window.sh"
cd "$2" || exit 1

start_display 5000x3000
"$program" view scene.sdf --size 320x240 >out.txt 2>log.txt &
window=$!
await_window scene.sdf 320x240
sizes=()
for ((i = 0; i < 150; ++i)); do sizes+=(windowsize "$id" 1 1 windowsize "$id" 5000 3000); done
for ((i = 0; i < 12; ++i)); do
  xdotool "${sizes[@]}"
  sleep 0.1
done
xdotool windowsize "$id" 320 240
press q
wait $window
