#!/usr/bin/env bash
# output_test.sh RUN PROGRAM: where glint's output may go besides files: to standard output, devices and pipes, which are
# written in place. A full device is an error, and never is a device replaced by a file.
set -euo pipefail

run=$1 program=$2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
expect() { # expect WHAT CONDITION...
    local what=$1
    shift
    "$@" || { echo "failed: $what"; cat "$folder"/error; exit 1; }
}
glint() { "$run" "$program" "$@" 2>"$folder/error"; }
is_png() { [[ $(head -c 4 "$1" | tail -c 3) == PNG ]]; }
render() { glint render builtin:exact --size 32x18 "$@"; }

full() { # full ARGUMENTS...
    local status=0
    glint "$@" >/dev/full || status=$?
    expect "glint $* on a full disk ends with 1" [ "$status" = 1 ]
    expect "and is said" grep -q "standard output: No space left on device" "$folder/error"
    expect "in one line" [ "$(wc -l <"$folder/error")" = 1 ]
}
full settings
full --version
full --help
full --help-all
commands=$(glint --help | sed -n '/^Subcommands:/,$ s/^  \([a-z]\+\) .*/\1/p' | sort)
expect "the help lists the commands" grep -q '^settings$' <<<"$commands"
for command in $commands; do
    full "$command" --help
done

render -o - >"$folder/picture"
expect "-o - prints a PNG" is_png "$folder/picture"
render -o /dev/stdout >"$folder/picture"
expect "-o /dev/stdout does, too" is_png "$folder/picture"
render -o /dev/null --view color,outcome --stats - >"$folder/stats"
expect "--stats - prints JSON" python3 -m json.tool "$folder/stats" "$folder/json"
expect "/dev/null is still a device" [ -c /dev/null ]
(echo before && render -o /dev/null --stats /dev/stdout && echo after) >"$folder/all"
expect "/dev/stdout is written after what was there" [ "$(head -n 1 "$folder/all")$(tail -n 1 "$folder/all")" = beforeafter ]

status=0
render -o /dev/null --stats /dev/full || status=$?
expect "a full device ends with 1" [ "$status" = 1 ]
expect "and is said by its name" grep -q "/dev/full: No space left on device" "$folder/error"
expect "/dev/full is still a device" [ -c /dev/full ]
