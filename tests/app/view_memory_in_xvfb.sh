#!/usr/bin/env bash
# view_memory_in_xvfb.sh PROGRAM FOLDER: opens scene.sdf of the folder, makes its window large until the picture is fine, and
# small again. Succeeds if the window then holds little more than before.
set -u
program=$1
# shellcheck source-path=SCRIPTDIR source=../support/xvfb_window.sh
source "$(dirname "${BASH_SOURCE[0]}")/../support/xvfb_window.sh"
cd "$2" || exit 1

# above KB, below KB: what the window holds.
held() { awk '/^RssAnon:/ { print $2 }' "/proc/$window/status"; }
above() { (($(held) > $1)); }
below() { (($(held) < $1)); }

start_display 5000x3000
"$program" view scene.sdf --size 640x480 >out.txt 2>log.txt &
window=$!
await_window scene.sdf 640x480
sleep 2
before=$(held)
plane=$((5000 * 3000 * 12 / 1000)) # what a picture's radiance takes
xdotool windowsize "$id" 5000 3000
until_true above $((before + 3 * plane)) || exit 1 # a coarse picture takes less than the planes of a fine one
sleep 2
xdotool windowsize "$id" 640 480
until_true below $((before + plane / 4)) || exit 1
press q
wait $window
