#!/usr/bin/env bash
# debian_archive_test.sh REPOSITORY: where scripts/lib/debian13.sh takes packages of Debian 13 from: GLINT_DEBIAN_MIRROR, or
# else the system's apt sources; without either it says what to set. No address of an archive stands in the repository.
set -euo pipefail

repository=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
fail() { echo "failed: $*"; exit 1; } # as setup.sh has it, without its ends
. "$repository/scripts/lib/debian13.sh"
unset GLINT_DEBIAN_MIRROR
sources=
apt-get() { [[ $1 != indextargets ]] || printf '%s\n' "$sources"; }

expect() { [[ $2 == "$3" ]] || { echo "$1: expected '$3', got '$2'"; exit 1; }; }

sources=$'http://near.example/debian-security/\nhttp://near.example/pub/debian/\nhttp://far.example/debian'
expect "the first archive of Debian" "$(debian_archive)" "http://near.example/pub/debian/"
expect "no archive of Ubuntu there" "$(apt_archive ubuntu)" ""
(debian13_open "$work/apt")
expect "the source list" "$(cut -d ' ' -f 3- "$work/apt/sources.list")" "http://near.example/pub/debian/ trixie main"
GLINT_DEBIAN_MIRROR=http://mine.example/d
expect "the variable goes first" "$(debian_archive)" "http://mine.example/d"
unset GLINT_DEBIAN_MIRROR
for sources in "" "http://near.example/ubuntu/"; do
    expect "nothing without either" "$(debian_archive)" ""
    if said=$(debian13_open "$work/none"); then
        echo "apt was opened without an archive"
        exit 1
    fi
    [[ $said == "failed: "*"set GLINT_DEBIAN_MIRROR"* && $said != *$'\n'* ]] || { echo "it said: $said"; exit 1; }
done

hosts='\b(deb|ftp[0-9.a-z]*|security|snapshot|archive|ports)\.(debian|ubuntu)\.(org|com)\b'
if grep -rIE "$hosts" "$repository" --exclude-dir=.git --exclude-dir=.deps --exclude-dir=build --exclude="${0##*/}"; then
    echo "these lines name a host of packages; the system's apt sources name it, or GLINT_DEBIAN_MIRROR does"
    exit 1
fi
