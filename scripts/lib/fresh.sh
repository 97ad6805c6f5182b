# shellcheck shell=bash
# Sourced by scripts/check. Tries the project's own commands on systems that have nothing but a package manager: minimal
# roots of Debian 12, Debian 13 and Ubuntu 24.04, each made in build/fresh and removed after.

fresh_folder=$root/build/fresh

# fresh_archive SUITE: where its packages come from: an archive in this machine's apt sources, or GLINT_DEBIAN_MIRROR.
fresh_archive() {
    case $1 in
    noble) apt_archive ubuntu ;;
    *) debian_archive ;;
    esac
}

fresh_keyring() { [[ $1 == noble ]] && echo ubuntu-keyring || echo debian-archive-keyring; }

# fresh_possible SUITES...: whether roots can be made here, with what it takes installed; otherwise says why not.
fresh_possible() {
    local name
    if [[ $EUID != 0 ]] || ! unshare --mount --pid --fork true 2>/dev/null; then
        echo "no minimal root can be made: this takes root's rights, mounts among them"
        return 1
    fi
    for name in mmdebstrap $(for suite in "$@"; do fresh_keyring "$suite"; done | sort -u); do
        if [[ -z $(missing_packages "$name") ]] || has_candidate "$name"; then
            install_packages "$name"
        elif [[ $name == mmdebstrap ]]; then
            echo "no minimal root can be made: this machine's apt sources have no mmdebstrap"
            return 1
        fi
    done
}

# fresh_root SUITE COMMAND: runs COMMAND in a root of SUITE, in a copy of the sources. One line says how it went, after
# the whole output where it failed. Returns 77 where this machine has no packages of SUITE.
fresh_root() {
    local suite=$1 command=$2 log=$fresh_folder/$1.log archive status=0
    archive=$(fresh_archive "$suite")
    if [[ -z $archive || -n $(missing_packages "$(fresh_keyring "$suite")") ]]; then
        echo "$suite: skipped, this machine's apt sources name no archive of it$([[ $suite == noble ]] || echo ", nor does GLINT_DEBIAN_MIRROR")"
        return 77
    fi
    # Mounts and processes live in namespaces of their own: none outlives this line, whatever ends it.
    GLINT_DEBIAN_MIRROR=$(debian_archive) nice unshare --mount --pid --fork --kill-child "$lib_dir/in-fresh-root" \
        "$suite" "$archive" "$fresh_folder/$suite" "$command" >"$log" 2>&1 </dev/null || status=$?
    rm -rf --one-file-system "${fresh_folder:?}/$suite"
    if [[ $status == 0 ]]; then
        echo "$suite: good, $SECONDS s"
    else
        cat "$log"
        echo "$suite: \`$command\` ended with $status"
        return 1
    fi
}

# fresh_roots at-once|in-turn COMMAND SUITES...: the same in several roots. Fails if one fails, and returns 77 if none
# could be tried.
fresh_roots() {
    local order=$1 command=$2 suite job tried=0 failed=0 jobs=()
    shift 2
    fresh_possible "$@" || return 77
    mkdir -p "$fresh_folder"
    exec 7>"$fresh_folder/lock"
    flock 7
    # shellcheck disable=SC2115
    for suite in "$@"; do rm -rf --one-file-system "$fresh_folder/$suite"; done # what an interrupted run left
    SECONDS=0
    note() { case $1 in 0) ((++tried)) ;; 77) ;; *) ((++tried, ++failed)) ;; esac; }
    for suite in "$@"; do
        if [[ $order == at-once ]]; then
            fresh_root "$suite" "$command" 7>&- &
            jobs+=($!)
        else
            status=0
            fresh_root "$suite" "$command" 7>&- || status=$?
            note "$status"
        fi
    done
    for job in "${jobs[@]}"; do
        status=0
        wait "$job" || status=$?
        note "$status"
    done
    [[ $tried != 0 ]] || return 77
    [[ $failed == 0 ]]
}
