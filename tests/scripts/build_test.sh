#!/usr/bin/env bash
# build_test.sh REPOSITORY: what scripts/lib/build.sh's build() prints, on a project of one file in a temporary folder:
# progress where something is built, nothing where nothing is to do, and why it failed.
set -euo pipefail

repository=$1
root=$(mktemp -d)
trap 'rm -rf "$root"' EXIT
fail() { echo "failed: $*" >"$root/message"; exit 1; } # as setup.sh has it, but to a file
. "$repository/scripts/lib/build.sh"

mkdir "$root/sources"
echo one >"$root/sources/a.txt"
cat >"$root/CMakeLists.txt" <<'END'
cmake_minimum_required(VERSION 3.25)
project(copies LANGUAGES NONE)
file(GLOB sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/sources/*.txt)
foreach(source ${sources})
    get_filename_component(name ${source} NAME)
    add_custom_command(OUTPUT ${name} COMMAND grep one ${source} > ${name} DEPENDS ${source})
    list(APPEND copies ${name})
endforeach()
add_custom_target(copies ALL DEPENDS ${copies})
END
cat >"$root/CMakePresets.json" <<'END'
{ "version": 6, "configurePresets": [ { "name": "test", "generator": "Ninja", "binaryDir": "${sourceDir}/build/test" } ] }
END

expect() { # expect WHAT CONDITION...: the condition holds, or the test fails with what build() printed
    local what=$1
    shift
    "$@" || { echo "$what; it printed:"; cat "$root/output"; exit 1; }
}
silent() { [[ ! -s $root/output ]]; }
says() { grep -q -F "$1" "$root/output"; }

build test >"$root/output" 2>&1
expect "the first build says what it does" says "Generating a.txt"
build test >"$root/output" 2>&1
expect "a build with nothing to do is silent" silent
echo one >"$root/sources/b.txt"
build test >"$root/output" 2>&1
expect "a new source file is found" says "Generating b.txt"
[[ -f $root/build/test/b.txt ]]
sleep 0.1 # files written within one tick of the clock (some ms) look equally old to ninja
echo two >"$root/sources/b.txt"
if (build test) >"$root/output" 2>&1; then
    echo "a failed build returned 0"
    exit 1
fi
expect "a failed build shows the command's own words" says "FAILED: b.txt"
expect "a failed build ends with one line" grep -q "building the preset test failed" "$root/message"
for script in demo test check; do
    "$repository/scripts/$script" --help >"$root/output" 2>&1
    expect "scripts/$script --help shows the comment at its head" says "scripts/$script ["
done
