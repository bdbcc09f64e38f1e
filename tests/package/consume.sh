#!/usr/bin/env bash
# consume.sh SOURCE BUILD installed|compiled|run_component|subdirectory|own_eigen|fetched: builds and runs the consumer project
# the named way: as headers, and with the libraries of the exact part where they are there (compiled: those of BUILD). Without git, or where SOURCE is no clone, the last one is left out (exit code 77).
set -euo pipefail
source=$1 build=$2 way=$3
work=$build/package/$way
rm -rf "$work"
mkdir -p "$work"

install_library() {
    cmake -S "$source" -B "$work/library" -G Ninja -DCMAKE_INSTALL_PREFIX="$work/prefix" \
        -DSTAGECRAFT_TOOL=OFF -DSTAGECRAFT_TESTS=OFF -DSTAGECRAFT_EXAMPLES=OFF -DSTAGECRAFT_COMPILED=OFF
    cmake --install "$work/library"
}
version=$(sed -n 's/^project(stagecraft VERSION \([0-9]*\.[0-9]*\).*/\1/p' "$source/CMakeLists.txt")
consume() {  # consume FOLDER CMAKE-ARGUMENT...
    local folder=$work/$1
    shift
    cmake -S "$source/tests/package/consumer" -B "$folder" -G Ninja -DWANTED="$version" "$@"
    cmake --build "$folder"
    "$folder/consumer"
}
case $way in
    installed)
        install_library
        consume consumer -DCMAKE_PREFIX_PATH="$work/prefix"
        ;;
    compiled)
        for component in headers libraries; do
            cmake --install "$build" --prefix "$work/prefix" --component "$component"
        done
        consume consumer -DCMAKE_PREFIX_PATH="$work/prefix" -DCOMPILED=ON
        consume header_only -DCMAKE_PREFIX_PATH="$work/prefix" -DHEADER_ONLY=ON
        ;;
    run_component)
        install_library
        consume consumer -DCMAKE_PREFIX_PATH="$work/prefix" -DPART=run -DCMAKE_DISABLE_FIND_PACKAGE_Boost=ON
        ;;
    subdirectory)
        consume consumer -DSTAGECRAFT_SOURCE="$source" -DSTAGECRAFT_COMPILED=OFF
        ;;
    own_eigen)  # Eigen is a part of the consumer's project, in no export set; what is installed is the consumer's affair
        consume consumer -DSTAGECRAFT_SOURCE="$source" -DPART=run -DOWN_EIGEN=ON -DCMAKE_UNITY_BUILD=ON \
            -DCMAKE_DISABLE_FIND_PACKAGE_Boost=ON
        cmake --install "$work/consumer" --prefix "$work/prefix"
        [ ! -e "$work/prefix/include" ]
        ;;
    fetched)
        git -C "$source" rev-parse HEAD || exit 77
        repository=file://$(git -C "$source" rev-parse --show-toplevel)
        consume missing -DSTAGECRAFT_REPOSITORY="$repository" -DFETCHED=ON -DPART=tableaux -DCOMPILED=ON
        install_library
        consume present -DSTAGECRAFT_REPOSITORY="$repository" -DFETCHED=OFF -DCMAKE_PREFIX_PATH="$work/prefix"
        ;;
esac
