# shellcheck shell=bash
# Sourced by setup.sh. Decides which Vulkan driver programs run on and makes sure that it is there. The decision is
# written to .deps/driver, which run-with-driver reads: `system` (a GPU, or a new enough Mesa), or `unpacked` (Debian
# 13's lavapipe in .deps/vulkan). GLINT_DRIVER=system or GLINT_DRIVER=unpacked overrides it.

driver_recipe=1 # raise when unpack_driver changes: what an older recipe unpacked is then replaced

# What the decision depends on: when none of it changes, the decision stands. Cheap, since every start asks.
driver_facts() {
    local file facts="recipe $driver_recipe ask ${GLINT_DRIVER:-}"
    for file in /dev/dri/renderD* /dev/nvidiactl /dev/dxg \
        /etc/vulkan/icd.d/*.json /usr/share/vulkan/icd.d/*.json /usr/local/share/vulkan/icd.d/*.json; do
        [[ -e $file ]] && facts+=" $file"
    done
    echo "$facts"
}

# Debian 13's lavapipe and its C library into .deps/vulkan, whole or not at all.
unpack_driver() {
    local work=$1 closure=$1/closure lib json
    debian13_unpack "$work" "$closure" install mesa-vulkan-drivers
    # Shared libraries and one manifest are all that is needed: no documents, no locales, no drivers for GPUs.
    lib=$(cd "$closure" && dirname usr/lib/*/libvulkan_lvp.so)
    json=$(cd "$closure" && echo usr/share/vulkan/icd.d/lvp_icd*.json)
    mkdir -p "$work/vulkan/$lib"
    mv "$closure"/usr/lib/*/libvulkan_lvp.so "$work/vulkan/$lib/"
    rm -f "$closure/$lib"/libvulkan_*.so "$closure/$lib"/libVkLayer_*.so
    mv "$closure/$lib"/*.so* "$work/vulkan/$lib/"
    # The loader takes a path with a slash as relative to the manifest, so the folder can move with the repository.
    sed 's|"library_path": *"[^"]*"|"library_path": "./'"$lib"'/libvulkan_lvp.so"|' "$closure/$json" \
        >"$work/vulkan/lvp_icd.json"
    touch "$work/vulkan/recipe-$driver_recipe"
    rm -rf "$deps/vulkan"
    mv "$work/vulkan" "$deps/vulkan"
}

probe_driver() { # probe_driver system|unpacked: names the device, or fails
    [[ -x $deps/vulkan-probe && $deps/vulkan-probe -nt $lib_dir/vulkan-probe.c ]] ||
        cc -O1 -o "$deps/vulkan-probe" "$lib_dir/vulkan-probe.c" -lvulkan
    GLINT_DRIVER=$1 "$lib_dir/run-with-driver" "$deps/vulkan-probe" 2>/dev/null
}

choose_driver() {
    local facts chosen device mesa
    facts=$(driver_facts)
    if [[ -f $deps/driver && $(<"$deps/driver") == *" $facts" ]]; then
        [[ $(<"$deps/driver") == unpacked* && ! -f $deps/vulkan/lvp_icd.json ]] || return 0
    fi

    if [[ ${GLINT_DRIVER:-system} == system ]]; then
        chosen=system
        if ! device=$(probe_driver system); then
            # Ray query came to lavapipe in Mesa 24.1: from there on the distribution's own package will do.
            mesa=$(LC_ALL=C apt-cache policy mesa-vulkan-drivers | awk '/Candidate:/ { print $2 }')
            if dpkg --compare-versions "$mesa" ge 24.1; then install_packages mesa-vulkan-drivers; fi
            device=$(probe_driver system) || chosen=unpacked
        fi
    else
        chosen=unpacked
    fi
    if [[ $chosen == unpacked ]]; then
        [[ ${GLINT_DRIVER:-} != system ]] || fail "GLINT_DRIVER=system, but no system driver has Vulkan 1.3 with descriptor indexing: unset it"
        if [[ ! -f $deps/vulkan/recipe-$driver_recipe ]]; then
            say "unpacking Debian 13's software Vulkan driver into .deps/vulkan (57 MB to download)"
            with_debian13 unpack_driver
        fi
        device=$(probe_driver unpacked) || fail "the driver in .deps/vulkan does not start: remove .deps and try again"
    fi
    say "Vulkan device: $device"
    echo "$chosen $(driver_facts)" >"$deps/driver.new" && mv "$deps/driver.new" "$deps/driver"
}

# CMake arguments that link programs to the unpacked driver's loader and libraries, one a line; none where the system's
# driver is used. A program started by that loader on the command line hides its own name from the sanitizers, which
# then name no function in a report and no leak for certain. run-with-driver starts a program linked so as it is.
linked_driver_arguments() {
    local loader
    [[ $(<"$deps/driver") == unpacked* ]] || return 0
    loader=$(echo "$deps"/vulkan/usr/lib/*/ld-linux*.so.*)
    echo "-DCMAKE_EXE_LINKER_FLAGS=-Wl,--dynamic-linker=$loader,--disable-new-dtags,-rpath,${loader%/*},--allow-shlib-undefined"
}
