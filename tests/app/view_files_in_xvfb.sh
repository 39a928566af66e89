#!/usr/bin/env bash
# view_files_in_xvfb.sh PROGRAM FOLDER: opens broken.sdf of the folder, which has a mistake, in a window on a display of its
# own, then mends it and goes through the other files. Leaves there: exit_code_broken of a window that does not wait,
# message.png, mended.png, skipped.png, back.png, exit_code, and log.txt.
set -u
program=$1
# shellcheck source-path=SCRIPTDIR source=../support/xvfb_window.sh
source "$(dirname "${BASH_SOURCE[0]}")/../support/xvfb_window.sh"
cd "$2" || exit 1

start_display 400x300
"$program" view broken.sdf --watch --size 320x240 2>log.txt >out.txt &
window=$!
await_window broken.sdf 320x240
press Tab
until_true drawn message.png || exit 1
"$program" view broken.sdf --size 320x240 2>/dev/null
echo $? >exit_code_broken
sed -i '/nonsense/d' broken.sdf
until_true changed mended.png message.png || exit 1
press Page_Down
has_skipped() { xdotool search --name '^lichtraum - last.sdf$' >/dev/null; }
until_true has_skipped || exit 1
until_true changed skipped.png mended.png || exit 1
press Page_Down
until_true changed back.png skipped.png || exit 1
press q
wait $window
echo $? >exit_code
