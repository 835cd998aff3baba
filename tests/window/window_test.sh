#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The window, by real keys and a real mouse on a virtual display: window_test.sh PROGRAM. 77: what it needs is not here.
set -euo pipefail
# What drivers of X leave behind cannot be named once they are unloaded: leaks are looked for by the tests without a window.
export ASAN_OPTIONS="${ASAN_OPTIONS:+$ASAN_OPTIONS:}detect_leaks=0"
program=$1
for tool in xvfb-run xdotool; do
  command -v "$tool" > /dev/null || { echo "skipped: no $tool"; exit 77; }
done
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"

cat > hands.sh <<'HANDS'
set -euo pipefail
fail() { echo "FAILED: $1"; cat log; exit 1; }
program=$1
begin() { open_window show --threads 2 "$@"; }
open_window() {
  "$program" "$@" > log 2>&1 &
  show=$!
  for _ in $(seq 100); do
    window=$(xdotool search --onlyvisible --pid $show 2> /dev/null | tail -1) && [[ -n $window ]] && break
    kill -0 $show 2> /dev/null || fail "the program ended"
    sleep 0.1
  done
  xdotool windowfocus "$window"
}
begin lecture-grid --size 960x540 --theme dark
# Waits until the title, which shows spheres, method and time, changes, for ten seconds at most.
expect_title() {
  for _ in $(seq 100); do
    title=$(xdotool getwindowname "$window")
    [[ $title == *"$1"* ]] && return
    sleep 0.1
  done
  fail "the title is '$title', expected $1"
}
expect_file() {
  for _ in $(seq 100); do
    [[ -s $1 ]] && return
    sleep 0.1
  done
  fail "no $1"
}
expect_title "20 spheres, linked-cell"
expect_title "0.000 ms a step"  # nothing moves until somebody plays
sleep 1; expect_title "0.000 ms a step"
xdotool key Right Right shift+Right Left Escape  # through the slide's kernel, and out of it
xdotool key space; sleep 0.5; xdotool key space
for _ in $(seq 50); do [[ $(xdotool getwindowname "$window") != *" 0.000 ms"* ]] && break; sleep 0.1; done
[[ $(xdotool getwindowname "$window") != *" 0.000 ms"* ]] || fail "it does not play"
xdotool key F1 Tab Tab F11 F11
xdotool key 1; expect_title "brute-force"
xdotool key 2; expect_title "sort-and-sweep"
xdotool key 4; expect_title "sorted-grid"
xdotool key 3; expect_title "linked-cell"
xdotool key space period comma i p l n v g t h F1 F1
xdotool mousemove --window "$window" 600 300 mousedown 1 mousemove --window "$window" 700 320 mouseup 1
xdotool mousemove --window "$window" 600 270 click 1 click 4 click 5
xdotool key s
expect_file picture_00000.png
xdotool key s
expect_file picture_00001.png
xdotool keydown s sleep 1.5 keyup s  # a key that is held acts once,
expect_file picture_00002.png; sleep 0.5
[[ ! -e picture_00003.png ]] || fail "a key that is held saves picture after picture"
xdotool windowsize --sync "$window" 20 10
xdotool windowsize --sync "$window" 800 600
xdotool key space 1; expect_title "brute-force"
kill -0 $show || fail "the program ended"
kill -INT $show
wait $show || fail "exit status $?"
[[ ! -s log ]] || fail "it said something"

# Starts again with the remembered settings; an unreadable file is reported and ignored.
export XDG_CONFIG_HOME=$PWD/config
end() { kill -INT $show; wait $show || fail "exit status $?"; }
begin lecture-grid --remember --size 640x480; expect_title "linked-cell"; xdotool key 2 t; expect_title "sort-and-sweep"; end
grep -q '"broadphase": "sort-and-sweep"' config/ballpit/show.json && grep -q '"theme": "dark"' config/ballpit/show.json || fail "not remembered"
begin --remember; expect_title "20 spheres, sort-and-sweep"; end
[[ ! -s log ]] || fail "it said something"
begin lecture-grid; expect_title "linked-cell"; end
echo "{" > config/ballpit/show.json
begin lecture-grid --remember --size 640x480; expect_title "linked-cell"; end
[[ $(wc -l < log) == 1 ]] && grep -q "note: --remember: nothing is remembered: .*show.json" log || fail "no note"

# The hand: throws a sphere, drops one in, pushes a handful, and saves what it did; the same run again has that state.
begin lecture-grid --size 960x540; expect_title "20 spheres"
drag() { xdotool mousemove --window "$window" $1 $2 mousedown 1 sleep 0.1 mousemove --window "$window" $3 $4 sleep 0.1 mouseup 1 sleep 0.1; }
xdotool keydown shift; drag 597 163 640 110; xdotool keyup shift
xdotool keydown shift mousemove --window "$window" 512 439 click 1 keyup shift; expect_title "21 spheres"
xdotool keydown ctrl; drag 563 295 540 270; xdotool keyup ctrl
xdotool mousemove --window "$window" 178 485 click 1
expect_file acts_00000.toml
for act in throw drop push; do grep -q "act = \"$act\"" acts_00000.toml || fail "no $act"; done
grep -A1 'act = "throw"' acts_00000.toml | grep -q "sphere = 15" || fail "another sphere is thrown"
xdotool mousemove --window "$window" 620 100 mousedown 1 mousemove --window "$window" 640 120 mouseup 1  # turns, acts no more
end
[[ ! -s log ]] || fail "it said something"
begin lecture-grid --size 960x540 --acts acts_00000.toml; expect_title "21 spheres"; end
"$program" simulate lecture-grid --time 0.1 --acts acts_00000.toml --json | grep -q '"count": 21' || fail "not the same run"

# A lecture by the presenter's keys.
open_window lecture --size 960x540; expect_title "Fast collision detection"
xdotool key Next; expect_title "project the scene on an axis"
xdotool key Next; expect_title "into one list"
xdotool key space; expect_title "Sort the list"
xdotool key Next Next; expect_title "walks the list"
xdotool key Prior; expect_title "Sort the list"
xdotool key 2 2 Return; expect_title "two threads insert"
xdotool key Right Right Left shift+Right shift+Left b period Tab Tab p p r
xdotool key d; expect_title "gleichzeitig"
xdotool key d End; expect_title "lights the picture"
xdotool key Home; expect_title "Fast collision"
xdotool mousemove --window "$window" 300 250 click 3; sleep 0.3; xdotool click 3  # the panel, and away again
xdotool mousemove --window "$window" 300 250 click 1
xdotool key Escape
wait $show || fail "exit status $?"
[[ ! -s log ]] || fail "the lecture said something"
status=0; "$program" show --size 16384x16384 2> log || status=$?
[[ $status == 2 && $(wc -l < log) == 1 ]] && grep -q -- "--size: found 16384x16384, allowed at most 5120x4096 on this display" log || fail "no line of the size"
HANDS
timeout 120 xvfb-run -a -s "-screen 0 1280x1024x24 -noreset" bash hands.sh "$program" || { echo "status $?"; exit 1; }

env -u DISPLAY -u WAYLAND_DISPLAY "$program" show lecture-grid > /dev/null 2> no_display && { echo "FAILED: a window without a display"; exit 1; }
[[ $(wc -l < no_display) == 1 ]] && grep -q "no window: .*ballpit render draws without a display" no_display || { echo "FAILED:"; cat no_display; exit 1; }
echo passed
