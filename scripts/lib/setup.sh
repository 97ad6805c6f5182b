# shellcheck shell=bash
# Sourced by the scripts that build or run something. `setup` makes sure that the packages, VMA's header and a Vulkan
# driver are there: silent and quick when they are, otherwise it says what it does, and it never asks.

lib_dir=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
root=$(cd "$lib_dir/../.." && pwd -P)
deps=$root/.deps

say() { doing=$* && echo "glint: $*" >&2; }
fail() { trap - EXIT; echo "glint: $*" >&2; exit 1; }

# help_asked ARGUMENT: whether a script's first argument asks what the script does; then the comment at its head is shown.
help_asked() {
    [[ $1 == --help || $1 == -h ]] || return 1
    sed -n '2,/^[^#]/s/^# \{0,1\}//p' "$0"
}

. "$lib_dir/packages.sh"
. "$lib_dir/debian13.sh"
. "$lib_dir/driver.sh"

# with_debian13 FUNCTION: calls FUNCTION WORK, where WORK is a folder in .deps with Debian 13's apt, removed after.
with_debian13() {
    local work=$deps/unpacking
    install_packages debian-archive-keyring # in every Debian; Ubuntu may lack it
    rm -rf "$work"                          # what an interrupted set-up left
    debian13_open "$work" >&2
    "$@" "$work" >&2
    rm -rf "$work"
}

# VMA is one header: a package of Debian 13 and Ubuntu 24.04, not of Debian 12.
ensure_vma() {
    [[ ! -f /usr/include/vk_mem_alloc.h && ! -f $deps/vma/include/vk_mem_alloc.h ]] || return 0
    if has_candidate libvulkan-memory-allocator-dev; then
        install_packages libvulkan-memory-allocator-dev
    else
        say "unpacking VMA's header from Debian 13 into .deps/vma"
        with_debian13 unpack_vma
    fi
}

unpack_vma() {
    local work=$1
    debian13_unpack "$work" "$work/package" download libvulkan-memory-allocator-dev
    mkdir "$work/vma"
    mv "$work/package/usr/include" "$work/vma/include"
    rm -rf "$deps/vma"
    mv "$work/vma" "$deps/vma"
}

# setup [PACKAGES...]: everything that building and running takes, and the packages named.
setup() {
    doing="looking for what is missing"
    mkdir -p "$deps"
    exec 9>"$deps/lock"
    flock 9 # two terminals may start at once
    trap 'echo "glint: set-up failed ($doing): the lines above say why; fix that and start again" >&2' EXIT
    install_packages "${build_packages[@]}" "$@"
    ensure_vma
    choose_driver
    trap - EXIT
    exec 9>&-
}
