#!/usr/bin/env bash
# view_names_in_xvfb.sh PROGRAM FOLDER: opens a ball under four names of one letter, two of which the font lacks, in windows of
# 640x480. Leaves a picture of each there.
set -u
program=$1
# shellcheck source-path=SCRIPTDIR source=../support/xvfb_window.sh
source "$(dirname "${BASH_SOURCE[0]}")/../support/xvfb_window.sh"
cd "$2" || exit 1

# shows NAME PICTURE
shows() {
  sed -i "s/shape sphere [^ ]* /shape sphere $1 /; s/composite pair [^ ]* /composite pair $1 /" scene.sdf
  "$program" view scene.sdf --size 640x480 --samples 1 >out.txt 2>log.txt &
  window=$!
  await_window scene.sdf 640x480
  until_true drawn "$2.png" || exit 1
  click 25 87 # the arrow of the first row in the tree
  until_true changed "$2_unfolded.png" "$2.png" || exit 1
  press q
  wait $window
}

start_display 800x600
shows Ж zhe
shows ł stroke
shows 球 ball
shows 箱 box
