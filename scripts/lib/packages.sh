# shellcheck shell=bash
# Sourced by setup.sh. The packages that Glint is built and tested with, and how the missing ones get here.

build_packages=(
    build-essential cmake ninja-build ccache pkg-config git python3
    libvulkan-dev vulkan-validationlayers glslc spirv-tools libspirv-cross-c-shared-dev
    libglm-dev libfmt-dev libcli11-dev nlohmann-json3-dev
    libdraco-dev libmeshoptimizer-dev libwebp-dev libstb-dev libopenexr-dev libembree-dev
    libpagmo-dev # the optimiser of glint tune
    libglfw3-dev libimgui-dev fonts-dejavu-core # the viewer's window, lab/view alone
    libgtest-dev libgmock-dev libbenchmark-dev xvfb xdotool
)

# What some tests need, where the system has it: a browser for the pages of reports and sweeps, a job scheduler for
# sweeps. Tests without theirs are skipped, and scripts/test says so at its end.
test_packages=(chromium-headless-shell slurmctld slurmd slurm-client munge)

# Prints those of the named packages that are not installed.
missing_packages() {
    local installed name
    installed=" $(dpkg-query --show --showformat '${db:Status-Status}=${Package} ' "$@" 2>/dev/null) " || true
    for name in "$@"; do [[ $installed == *" installed=$name "* ]] || echo "$name"; done
}

has_candidate() { [[ $(LC_ALL=C apt-cache policy "$1") =~ Candidate:\ [^\(] ]]; }

as_root() {
    if [[ $EUID == 0 ]]; then "$@"; else sudo -n "$@"; fi
}

# packaged NAMES...: prints those of the named packages that this machine's apt sources have, or that are installed.
packaged() {
    local name
    for name in "$@"; do
        [[ -n $(missing_packages "$name") ]] && ! has_candidate "$name" || echo "$name"
    done
}

# install_packages NAMES...: installs what is missing of them, without a question.
install_packages() {
    local missing name apt=(env DEBIAN_FRONTEND=noninteractive apt-get -q -y -o DPkg::Lock::Timeout=300)
    mapfile -t missing < <(missing_packages "$@")
    [[ ${#missing[@]} -gt 0 ]] || return 0
    if [[ $EUID != 0 ]] && ! sudo -n true 2>/dev/null; then
        fail "packages are missing and this is neither root nor sudo without a password; run: sudo apt-get install --no-install-recommends ${missing[*]}"
    fi
    say "installing ${missing[*]}"
    for name in "${missing[@]}"; do
        has_candidate "$name" || { as_root "${apt[@]}" update >&2; break; }
    done
    for name in "${missing[@]}"; do
        has_candidate "$name" || fail "no package $name in this machine's apt sources (on Ubuntu: enable universe)"
    done
    # Lists that have grown old name files that the archive no longer has: then once more with fresh ones.
    as_root "${apt[@]}" install --no-install-recommends "${missing[@]}" >&2 || {
        as_root "${apt[@]}" update >&2
        as_root "${apt[@]}" install --no-install-recommends "${missing[@]}" >&2
    }
}
