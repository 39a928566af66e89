# shellcheck shell=bash
# To be sourced: functions that use a window of `lichtraum view` as a user would, on a display of its own. They need Xvfb,
# xdotool and ffmpeg, and write into the current folder.

# until_true COMMAND...: for at most two minutes, which a machine that also compiles may need.
until_true() {
  local end=$((SECONDS + 120))
  while ((SECONDS < end)); do
    "$@" && return 0
    sleep 0.1
  done
  echo "waited in vain: $*"
  return 1
}

# start_display WxH: the server ends with the script, as does what it put into $window.
start_display() {
  rm -f display
  Xvfb -displayfd 3 -screen 0 "$1x24" -nolisten tcp -noreset 3>display 2>/dev/null &
  server=$!
  trap 'kill $server $window 2>/dev/null' EXIT
  has_display() { [[ -s display ]]; }
  until_true has_display || exit 1
  DISPLAY=:$(cat display)
  export DISPLAY
  unset WAYLAND_DISPLAY
}

# await_window FILE WxH: until FILE's window is open.
await_window() {
  local title="^lichtraum - $1\$"
  window_size=$2
  is_open() { id=$(xdotool search --onlyvisible --name "$title" 2>/dev/null | head -n 1) && [[ -n $id ]]; }
  until_true is_open || exit 1
  xdotool windowfocus "$id"
  eval "$(xdotool getwindowgeometry --shell "$id")" # sets X and Y
}

# shot PICTURE: of the window.
shot() {
  ffmpeg -v error -y -f x11grab -draw_mouse 0 -video_size "$window_size" -i "$DISPLAY+$X,$Y" -frames:v 1 "$1"
}
# settled PICTURE: one that no longer changes.
settled() {
  shot "$1"
  sleep 0.4
  shot settled.png
  cmp -s "$1" settled.png
}
# drawn PICTURE: a settled one that is not black in the middle. A window is black until its first picture is there, for as
# long as a busy machine takes.
drawn() { settled "$1" && [[ -n $(ffmpeg -v error -i "$1" -vf crop=iw/4:ih/4 -f rawvideo -pix_fmt gray - | tr -d '\000-\017' | head -c 1) ]]; }
# changed PICTURE OTHER: a settled one that is not the other.
changed() { settled "$1" && ! cmp -s "$1" "$2"; }
without_text() { ffmpeg -v error -i "$1" -vf crop=iw:ih-120:0:120 -f rawvideo - 2>/dev/null; } # cmp may close the pipe early
# same PICTURE OTHER: one that is the other below the text at the top, which has the time that it took and may need a line more.
same() { shot "$1" && cmp -s <(without_text "$1") <(without_text "$2"); }

# press KEY... A window that closes at a key is gone before xdotool lets go of it, and fails then: the server takes such a key
# for one that is still held down, and drops its next press.
press() {
  xdotool key --window "$id" "$@" 2>/dev/null
  xdotool keyup "$@"
}
# drag X Y X Y: from a place in the window to another, with the left button.
drag() {
  xdotool mousemove $((X + $1)) $((Y + $2))
  sleep 0.2
  xdotool mousedown 1
  sleep 0.2
  xdotool mousemove $((X + $3)) $((Y + $4))
  sleep 0.2
  xdotool mouseup 1
  sleep 0.2
}
# click X Y
click() { drag "$1" "$2" "$1" "$2"; }
