#!/usr/bin/env bash
# consume.sh SOURCE BUILD installed|subdirectory: builds and runs the consumer project the named way.
set -euo pipefail
source=$1 build=$2 way=$3
work=$build/package/$way
rm -rf "$work"
mkdir -p "$work"
if [ "$way" = installed ]; then
    cmake -S "$source" -B "$work/library" -G Ninja -DCMAKE_INSTALL_PREFIX="$work/prefix" \
        -DSTAGECRAFT_TOOL=OFF -DSTAGECRAFT_TESTS=OFF -DSTAGECRAFT_EXAMPLES=OFF
    cmake --install "$work/library"
    argument=-DCMAKE_PREFIX_PATH=$work/prefix
else
    argument=-DSTAGECRAFT_SOURCE=$source
fi
cmake -S "$source/tests/package/consumer" -B "$work/consumer" -G Ninja "$argument"
cmake --build "$work/consumer"
"$work/consumer/consumer"
