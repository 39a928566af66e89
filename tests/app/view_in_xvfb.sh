#!/usr/bin/env bash
# view_in_xvfb.sh PROGRAM FOLDER: opens scene.sdf of the folder in a window on a display of its own, and does what a user
# would; then draws it with --show. Leaves there: opened.png, turned.png, saved.png, faulty.png, camera.sdf, exit_code,
# then written.png, shown.png, exit_code_shown, and log.txt.
set -u
program=$1
cd "$2" || exit 1

Xvfb -displayfd 3 -screen 0 400x300x24 -nolisten tcp 3>display 2>/dev/null &
server=$!
trap 'kill $server $window 2>/dev/null' EXIT

# until_true COMMAND...: for at most 20 seconds.
until_true() {
  for ((i = 0; i < 200; ++i)); do
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

shot() { ffmpeg -v error -y -f x11grab -video_size 320x240 -i "$DISPLAY+$position" -frames:v 1 "$1"; }
# A picture that does not change any more.
settled() {
  shot "$1"
  sleep 0.4
  shot settled.png
  cmp -s "$1" settled.png
}
# A settled one that is not the other.
changed() { settled "$1" && ! cmp -s "$1" "$2"; }
press() { xdotool key --window "$id" "$@"; }

is_open() { id=$(xdotool search --name '^lichtraum - scene.sdf$' 2>/dev/null | head -n 1) && [[ -n $id ]]; }
await_window() {
  until_true is_open || exit 1
  xdotool windowfocus "$id"
  eval "$(xdotool getwindowgeometry --shell "$id")" # sets X and Y
  position=$X,$Y
  shot empty.png
}

"$program" view scene.sdf --watch --size 320x240 >camera.sdf 2>log.txt &
window=$!
await_window
press Tab # the numbers change all the time
until_true changed opened.png empty.png || exit 1
press Right Right Right Up
until_true changed turned.png opened.png || exit 1
press c
has_camera() { grep -q translate camera.sdf; }
until_true has_camera || exit 1
press s
has_picture() { [[ -s scene_view_0001.png ]]; }
until_true has_picture || exit 1
sed -i 's/material red .*/material red 0 0 0  0 0.6 0  0 0 0  1/' scene.sdf
until_true changed saved.png turned.png || exit 1
echo 'define nonsense' >>scene.sdf
until_true changed faulty.png saved.png || exit 1
press q
wait $window
echo $? >exit_code

sed -i '$d' scene.sdf
"$program" render -q scene.sdf -o written.png --samples 2x2 --size 320x240 --show 2>>log.txt &
window=$!
await_window
press Tab
until_true changed shown.png empty.png || exit 1
press q
wait $window
echo $? >exit_code_shown
