#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Makes the window's picture of docs/reviewer.md on a virtual X server (packages xvfb, xdotool and imagemagick):
#   tests/window/window_picture.sh build/apps/litfog-demo data/pictures/window.jpg
set -euo pipefail
if [[ $# != 2 || ! -x "$1" ]]; then
  printf '%s\n' "usage: $0 LITFOG-DEMO PICTURE.jpg, of which the first must be a program" >&2
  exit 1
fi
demo=$(realpath "$1")
picture=$(realpath "$2")
folder=$(mktemp -d)
trap 'kill $(jobs -p) || true; wait; rm -r "$folder"' EXIT
cd "$folder"

Xvfb -displayfd 3 -screen 0 1280x720x24 -fbdir . -nolisten tcp 3>display 2>xvfb &
until [[ -s display ]]; do sleep 0.1; done
DISPLAY=":$(<display)" XDG_CONFIG_HOME="$folder"
export DISPLAY XDG_CONFIG_HOME
"$demo" window street --visibility 150 --size 1280x720 >said &
window=$!
timeout 120 xdotool search --sync --onlyvisible --name litfog

click() {
  xdotool mousemove "$1" "$2" sleep 0.3 mousedown 1 sleep 0.3 mouseup 1 sleep 0.3
}
click 22 78         # compares two settings, of which B, on the right,
click 105 411       # is drawn by peak
click 109 78        # A's settings and curves are shown
xdotool key ctrl+p  # is answered when the picture is whole
until [[ -s said ]]; do
  kill -0 "$window"  # has not ended
  sleep 0.5
done
click 652 58        # a lamp
xdotool mousemove 690 120 sleep 2  # the ray whose airlight is shown
convert xwd:Xvfb_screen0 -quality 85 "$picture"
