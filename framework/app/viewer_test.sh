#!/usr/bin/env bash
# The window, driven by a mouse and a keyboard on a virtual screen: a slider changes its setting and the
# picture, a broken shader shows an overlay that goes when it is mended, keys choose views and save the
# window, and what takes long does not keep the window from opening.
#
#   viewer_test.sh PROGRAM SHADER …   SHADER: the student's .glsl files; the program uses one at least
#
# Exit code 77: skipped. Waits for lines of PENUMBRA_UI_LOG, never for a time.
set -u
program=$1
shift
for tool in Xvfb xdotool; do
    command -v $tool > /dev/null || { echo "SKIP: $tool is not installed"; exit 77; }
done

folder=$(mktemp -d)
log=$folder/log
screen=0 window=0
finish() {
    for pid in $window $screen; do [ "$pid" != 0 ] && kill "$pid" 2> /dev/null; done
    wait 2> /dev/null
    rm -rf "$folder"
}
trap finish EXIT
fail() {
    echo "FAILED: $1"
    [ -f "$log" ] && tail -n 20 "$log"
    [ -f "$folder/stdout" ] && cat "$folder/stdout"
    exit 1
}
# waitFor PATTERN [LINES BEFORE]: until a later line of the log matches; 20 s at most.
waitFor() {
    for ((i = 0; i < 400; ++i)); do
        if tail -n +$((${2:-0} + 1)) "$log" 2> /dev/null | grep -qE "$1"; then return 0; fi
        kill -0 $window 2> /dev/null || fail "the program ended while waiting for '$1'"
        sleep 0.05
    done
    fail "no line '$1' within 20 s"
}
lines() { wc -l < "$log"; }
last() { grep -E "$1" "$log" | tail -n 1; }

mkfifo "$folder/display"
Xvfb -displayfd 7 -screen 0 1600x1000x24 -nolisten tcp 7> "$folder/display" > "$folder/xvfb" 2>&1 &
screen=$!
read -r -t 15 number < "$folder/display" || fail "Xvfb did not start"
export DISPLAY=:$number LP_NUM_THREADS=1

mkdir "$folder/layer"
cp "$@" "$folder/layer/"
touch "$log"
cd "$folder" || exit 1
PENUMBRA_CACHE=$folder/cache PENUMBRA_UI_LOG=$log "$program" open --scene boxes --layer "$folder/layer" > "$folder/stdout" 2>&1 &
window=$!
waitFor '^item [a-z_]+ .*' && waitFor '^truth done'
# Nothing is cached, so what takes long is made beside the first picture, which is drawn again with it.
if grep -q '^unfinished' "$log"; then
    waitFor '^finished'
    without=$(grep '^frame ' "$log" | head -n 1) with=$(last '^frame ')
    [ "${without##* }" != "${with##* }" ] || fail "the picture is still without its $(last '^unfinished')"
    echo "$(last '^unfinished'), finished: mean visibility ${without##* } -> ${with##* }"
fi

# Within a tenth of the range: a mouse meets a slider's pixel, and a whole number its neighbour.
inTheMiddle() {
    [ -n "$1" ] && awk -v v="$1" -v a="$minimum" -v b="$maximum" \
        'BEGIN { exit !((v - (a + b) / 2) ^ 2 <= (0.1 * (b - a)) ^ 2) }'
}

# Sliders of numbers, each from its left end to its middle, until one changes the picture.
moved=""
while read -r setting minimum maximum; do
    read -r _ _ x0 y0 x1 y1 <<< "$(last "^item $setting ")"
    before=$(last '^frame ') seen=$(lines)
    middle=$(((x0 + x1) / 2)) height=$(((y0 + y1) / 2))
    xdotool mousemove $((x0 + 6)) $height mousedown 1
    value=
    for ((i = 0; i < 100; ++i)); do  # a hand that trembles: some window systems drop the first move
        xdotool mousemove $((middle + i % 2)) $height
        sleep 0.1
        value=$(last "^setting $setting ")
        value=${value##* }
        inTheMiddle "$value" && break
    done
    xdotool mouseup 1
    sleep 1  # ImGui 1.86 looks once a frame, and a frame may take half a second: a press before it would be the same press
    inTheMiddle "$value" || fail "dragging $setting to the middle of $minimum … $maximum gave '$value'"
    waitFor '^frame ' "$seen"
    waitFor '^truth done' "$seen"
    after=$(last '^frame ')
    [ "${before##* }" != "${after##* }" ] && moved="$setting $value" && break
done < <("$program" list | awk '$3 == "…" { print $1, $2, $4 }')
[ -n "$moved" ] || fail "no slider changes the picture"
echo "slider: $moved, mean visibility ${before##* } -> ${after##* }"

# A typing error in the student's files, on the line after the last.
seen=$(lines)
for file in "$folder"/layer/*.glsl; do printf 'float blokcer( { return 0.0; }\n' >> "$file"; done
waitFor '^overlay .*\.glsl:[0-9]+: ' "$seen"
named=$(last '^overlay ' | grep -oE '[A-Za-z0-9_]+\.glsl:[0-9]+' | head -n 1)
[ "${named#*:}" = "$(wc -l < "$folder/layer/${named%:*}")" ] || fail "the overlay names $named"
echo "overlay: $(last '^overlay ')"
seen=$(lines)
cp "$@" "$folder/layer/"
waitFor '^overlay gone' "$seen"
waitFor '^frame ' "$seen"

seen=$(lines)
xdotool mousemove 400 300 key 5
waitFor '^view split' "$seen"
xdotool key p
waitFor '^screenshot ' "$seen"
picture=$(last '^screenshot ')
[ -s "$folder/${picture#screenshot }" ] || fail "no file at ${picture#screenshot }"
echo "keys: $(last '^view '), $picture"
