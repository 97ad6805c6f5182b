# shellcheck shell=bash
# Sourced by scripts/check: what others build from the library. Each returns 77, with the reason, where it cannot be done.

# library FOLDER CMAKE-ARGUMENTS...: builds the library alone in build/FOLDER.
library() {
    local folder=$root/build/$1
    shift
    cmake -G Ninja -S "$root" -B "$folder" -DCMAKE_PROJECT_TOP_LEVEL_INCLUDES="$root/cmake/ccache.cmake" \
        -DCMAKE_BUILD_TYPE=Release -DGLINT_BUILD_LAB=OFF -DGLINT_WERROR=ON "$@" >&2
    ninja -C "$folder" >&2
}

# The shared library, by Clang, without exceptions and type information: it exports its interface and nothing else, and
# the example hosts, which GCC compiles with both, draw with it what they draw with the static one.
shared() {
    local folder=$root/build/shared
    tool clang >/dev/null || { echo "no package clang in this machine's apt sources"; return 77; }
    library shared -DGLINT_BUILD_TESTS=OFF -DBUILD_SHARED_LIBS=ON -DCMAKE_C_COMPILER=clang \
        -DCMAKE_CXX_COMPILER=clang++ -DCMAKE_CXX_FLAGS="-fno-exceptions -fno-rtti"
    # Weak symbols are copies of templates, as the optimizer leaves them: all are glint's (cmake/glint.map).
    nm --dynamic --defined-only --demangle "$folder/libglint.so" | sed -n 's/^[^ ]* [^WVu] //p' | LC_ALL=C sort -u \
        >"$folder/exports.txt"
    diff -u "$root/tests/abi/exports.txt" "$folder/exports.txt" || {
        echo "libglint.so exports other symbols than tests/abi/exports.txt says; is that meant? Then copy build/shared/exports.txt"
        return 1
    }
    cmake -DBUILD="$folder" -DSOURCE="$root" -DWORK="$folder/embed" -DGENERATOR=Ninja -DCOMPILER=c++ -DC_COMPILER=cc \
        -DDRIVER="$lib_dir/run-with-driver" -P "$root/tests/embed/embed.cmake"
}

# mingw_examples FOLDER...: the example hosts for Windows, against what each of these builds installs. They link Windows'
# Vulkan loader, for which Linux has no import library: one is made of the functions that they name.
mingw_examples() {
    local headers=$root/build/mingw/headers work=$root/build/mingw-examples built example name
    rm -rf "$work"
    mkdir -p "$work"
    {
        printf 'LIBRARY vulkan-1.dll\nEXPORTS\n'
        grep -ohE '\bvk[A-Z][A-Za-z0-9]*' "$root"/examples/embed/* "$root"/examples/embed-c/* | sort -u |
            while read -r name; do ! grep -q "VKAPI_CALL $name(" "$headers/vulkan/vulkan_core.h" || echo "$name"; done
    } >"$work/vulkan-1.def"
    x86_64-w64-mingw32-dlltool -d "$work/vulkan-1.def" -l "$work/libvulkan-1.a"
    for built in "$@"; do
        cmake --install "$root/build/$built" --prefix "$work/$built" >&2
        for example in embed embed-c; do
            cmake -G Ninja -S "$root/examples/$example" -B "$work/$built-$example" \
                --toolchain "$root/cmake/mingw-w64-x86_64.cmake" "-Dglint_DIR=$work/$built/lib/cmake/glint" \
                "-DVulkan_LIBRARY=$work/libvulkan-1.a" "-DVulkan_INCLUDE_DIR=$headers" >&2
            ninja -C "$work/$built-$example" >&2
        done
    done
}

# The library for Windows, by MinGW-w64, static and shared, and the example hosts with both. Where Wine is installed, its
# tests that need no device run, and structs have the layout of Linux.
mingw() {
    local folder=$root/build/mingw
    tool g++-mingw-w64-x86-64-posix >/dev/null ||
        { echo "no package g++-mingw-w64-x86-64-posix in this machine's apt sources"; return 77; }
    tool googletest >/dev/null
    library mingw-shared --toolchain "$root/cmake/mingw-w64-x86_64.cmake" -DGLINT_BUILD_TESTS=OFF -DBUILD_SHARED_LIBS=ON
    library mingw --toolchain "$root/cmake/mingw-w64-x86_64.cmake" -DGLINT_BUILD_TESTS=ON
    mingw_examples mingw mingw-shared
    type -P wine >/dev/null || { echo "built; no Wine here, so no test ran"; return 0; }
    export WINEPREFIX=$folder/wine WINEDEBUG=-all
    (cd "$folder" && wine bin/glint_unit_tests.exe --gtest_brief=1 2>&1)
    python3 "$root/tests/abi/layout.py" "$root/include/glint/glint.h" >"$folder/layout.c"
    x86_64-w64-mingw32-gcc-posix -std=c99 -D__USE_MINGW_ANSI_STDIO=1 -I "$root/include" -I "$folder/headers" \
        "$folder/layout.c" -static -o "$folder/layout.exe"
    wine "$folder/layout.exe" 2>/dev/null | tr -d '\r' | diff -u "$root/tests/abi/layout.txt" -
}

# The reference of include/glint, without a warning: build/api/html/index.html.
api() {
    tool doxygen >/dev/null || { echo "no package doxygen in this machine's apt sources"; return 77; }
    mkdir -p "$root/build"
    (cat "$root/packaging/api/Doxyfile" && echo "OUTPUT_DIRECTORY = build/api") | doxygen -
}

# Debian packages of the last commit, in build/deb, and what lintian finds in them.
deb() {
    local work=$root/build/deb/glint arguments=() ignore=() name
    for name in debhelper lintian; do
        tool "$name" >/dev/null || { echo "no package $name in this machine's apt sources"; return 77; }
    done
    rm -rf "$root/build/deb"
    mkdir -p "$work"
    git -C "$root" archive HEAD | tar -x -C "$work"
    cp -r "$work/packaging/debian" "$work/debian"
    if [[ -d $deps/vma ]]; then # Debian 12 has no package of VMA
        arguments=("-DVMA_INCLUDE_DIR=$deps/vma/include")
        ignore=(--no-check-builddeps)
    fi
    (cd "$work" && GLINT_CMAKE_ARGUMENTS="${arguments[*]}" nice dpkg-buildpackage -us -uc -b "${ignore[@]}") >&2
    # The project has no address for mail, so packaging/debian says localhost; a distributor puts in its own.
    lintian --fail-on error,warning --suppress-tags bogus-mail-host,bogus-mail-host-in-debian-changelog \
        "$root"/build/deb/*.changes
}
