#!/usr/bin/env bash
# view_panel_in_xvfb.sh PROGRAM FOLDER: opens scene.sdf of the folder in a window of 640x480 on a display of its own and
# uses the panel as a user would. Leaves the pictures there that view_panel_test.cpp looks at, log.txt, and exit_code.
set -u
program=$1
cd "$2" || exit 1

Xvfb -displayfd 3 -screen 0 800x600x24 -nolisten tcp 3>display 2>/dev/null &
server=$!
trap 'kill $server $window 2>/dev/null' EXIT

# until_true COMMAND...: for at most 30 seconds.
until_true() {
  for ((i = 0; i < 300; ++i)); do
    "$@" && return 0
    sleep 0.1
  done
  echo "waited in vain: $*"
  return 1
}
has_display() { [[ -s display ]]; }
until_true has_display || exit 1
DISPLAY=:$(cat display)
export DISPLAY
unset WAYLAND_DISPLAY

shot() { ffmpeg -v error -y -f x11grab -draw_mouse 0 -video_size 640x480 -i "$DISPLAY+$X,$Y" -frames:v 1 "$1"; }
# A picture that does not change any more, and is not the other.
settled() {
  shot "$1"
  sleep 0.5
  shot settled.png
  cmp -s "$1" settled.png
}
changed() { settled "$1" && ! cmp -s "$1" "$2"; }
# click X Y: in the window.
click() {
  xdotool mousemove $((X + $1)) $((Y + $2))
  sleep 0.2
  xdotool mousedown 1
  sleep 0.2
  xdotool mouseup 1
  sleep 0.2
}
press() { xdotool key --window "$id" "$@"; }

"$program" view scene.sdf --size 640x480 >out.txt 2>log.txt &
window=$!
is_open() { id=$(xdotool search --onlyvisible --name '^lichtraum - scene.sdf$' 2>/dev/null | head -n 1) && [[ -n $id ]]; }
until_true is_open || exit 1
xdotool windowfocus "$id"
eval "$(xdotool getwindowgeometry --shell "$id")" # sets X and Y

shot empty.png
until_true changed opened.png empty.png || exit 1
click 480 240 # the ball
until_true changed picked.png opened.png || exit 1
click 600 470 # nothing
until_true changed nothing.png picked.png || exit 1
click 33 95 # the arrow of the first row in the tree
until_true changed unfolded.png nothing.png || exit 1
click 70 95 # the row itself
until_true changed chosen.png unfolded.png || exit 1
click 600 470
until_true changed again.png chosen.png || exit 1
click 100 250 # the lights
click 60 270  # the first of them
until_true changed lights.png again.png || exit 1
click 39 290 # its brightness: none
until_true changed dark.png lights.png || exit 1
click 55 357 # reset
until_true changed reset.png dark.png || exit 1
press d
until_true changed depth.png reset.png || exit 1
press n
until_true changed normal.png depth.png || exit 1
press o
until_true changed id.png normal.png || exit 1
press p
until_true changed picture.png id.png || exit 1
press q
wait $window
echo $? >exit_code
