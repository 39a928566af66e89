#!/usr/bin/env bash
# view_reading_in_xvfb.sh PROGRAM FOLDER: closes a window whose scene is still being read. Succeeds if it is gone before that
# ends.
set -u
program=$1
# shellcheck source-path=SCRIPTDIR source=../support/xvfb_window.sh
source "$(dirname "${BASH_SOURCE[0]}")/../support/xvfb_window.sh"
cd "$2" || exit 1

start_display 400x300
mkfifo slow.sdf # which nobody ever writes to
"$program" view slow.sdf --size 320x240 >out.txt 2>log.txt &
window=$!
await_window slow.sdf 320x240
is_gone() {
  press q
  ! xdotool search --onlyvisible --name '^lichtraum' >/dev/null
}
until_true is_gone || exit 1
kill -0 $window
