# shellcheck shell=bash
# Sourced by setup.sh. Unpacks packages of Debian 13 into a folder, without touching the system's own packages: apt
# resolves, downloads and verifies them with a state, a cache and a source list of its own. Needs no root.

debian13_keyring=/usr/share/keyrings/debian-archive-keyring.gpg

# apt_archive NAME: the first archive in the system's apt sources whose address ends with NAME (debian, ubuntu), by the
# custom of mirrors; nothing without one. The origin that archives state is known only after `apt-get update`.
apt_archive() {
    # shellcheck disable=SC2016 # the dollar is apt's
    apt-get indextargets --format '$(REPO_URI)' 'Created-By: Packages' 2>/dev/null |
        awk -v name="$1" '$0 ~ "/" name "/?$" && !found { found = 1; print }' || true
}

# The archive that Debian 13's packages come from: GLINT_DEBIAN_MIRROR, or else that of the system's apt sources.
debian_archive() { echo "${GLINT_DEBIAN_MIRROR:-$(apt_archive debian)}"; }

# debian13_open DIR: an apt in DIR that knows nothing but Debian 13.
debian13_open() {
    local dir=$1 archive
    archive=$(debian_archive)
    [[ -n $archive ]] || fail "this takes packages of Debian 13, and this machine's apt sources name no archive of Debian: \
set GLINT_DEBIAN_MIRROR to the address of one (the part of an apt source before the suite)"
    mkdir -p "$dir"/{none,state/lists/partial,cache/archives/partial}
    : >"$dir/status" # no package counts as installed: a closure is everything, the C library included
    echo "deb [signed-by=$debian13_keyring] $archive trixie main" >"$dir/sources.list"
    debian13_apt=(apt-get -q -y
        -o "Dir::State=$dir/state" -o "Dir::State::status=$dir/status" -o "Dir::Cache=$dir/cache"
        -o "Dir::Etc::sourcelist=$dir/sources.list" -o "Dir::Etc::sourceparts=$dir/none"
        -o "Dir::Etc::preferences=$dir/none/none" -o "Dir::Etc::preferencesparts=$dir/none"
        -o "Dir::Log=$dir" -o APT::Sandbox::User=root -o Acquire::Languages=none -o Acquire::Retries=3
        -o APT::Install-Recommends=false)
    "${debian13_apt[@]}" update
}

# debian13_unpack DIR INTO WORDS...: downloads what apt's words ask for and unpacks it into INTO.
# `install NAME` takes NAME with all that it depends on; `download NAME` takes NAME alone.
debian13_unpack() {
    local dir=$1 into=$2 deb
    shift 2
    mkdir -p "$into"
    rm -f "$dir"/cache/archives/*.deb
    (cd "$dir/cache/archives" && "${debian13_apt[@]}" --download-only "$@")
    for deb in "$dir"/cache/archives/*.deb; do
        dpkg-deb --extract "$deb" "$into"
    done
}
