# shellcheck shell=bash
# Sourced by the scripts that build: one CMake preset at a time, and its tests.

# build PRESET [TARGET]: configures where needed and builds. Silent when everything is up to date; otherwise the
# progress goes to standard error, for standard output belongs to the program that is run afterwards.
build() {
    local preset=$1 target=${2:-all} folder=$root/build/$1
    mkdir -p "$folder"
    exec 8>"$folder/lock"
    flock 8
    # Again after an edit of the presets, and after the repository was moved: CMake keeps absolute paths.
    if [[ ! -f $folder/build.ninja || $root/CMakePresets.json -nt $folder/build.ninja ]] ||
        ! grep -q -x -F "CMAKE_HOME_DIRECTORY:INTERNAL=$root" "$folder/CMakeCache.txt"; then
        (cd "$root" && cmake --fresh --preset "$preset" "${cmake_arguments[@]}") >&2 ||
            fail "configuring the preset $preset failed: CMake says why above"
    fi
    # Every call globs the sources again, so `ninja -n` never knows that there is nothing to do: what is said then is
    # left out instead.
    ninja -C "$folder" "$target" 2>&1 | grep --line-buffered -v -x -E \
        "ninja: Entering directory .*|\[0/[0-9]+\] Re-checking globbed directories\.\.\.|ninja: no work to do\." >&2 ||
        [[ ${PIPESTATUS[0]} == 0 ]] || fail "building the preset $preset failed: the first error above says why"
    exec 8>&-
}
cmake_arguments=() # what a script adds to the preset

# run_tests PRESET [CTEST-ARGUMENTS...]: runs the tests in parallel and sets passed, failed and skipped; fails if one
# does or if there are none.
run_tests() {
    local preset=$1 report=$root/build/$1/tests.xml results=$root/build/$1/test-results status=0
    shift
    rm -rf "$report" "$results"
    (cd "$root" && ctest --preset "$preset" --parallel "$(nproc)" --output-junit "$report" "$@") || status=$?
    passed=0 failed=1 skipped=0
    [[ -f $report ]] || return "$status"
    read -r passed failed skipped < <(python3 "$lib_dir/count_tests.py" "$report" "$results")
    [[ $status == 0 || $failed != 0 ]] || failed=1 # a test that could not start
    return "$status"
}

summary() { # summary PASSED FAILED SKIPPED: the last line of every script that tests
    echo "$1 passed, $2 failed$([[ $3 == 0 ]] || echo ", $3 skipped")"
}
