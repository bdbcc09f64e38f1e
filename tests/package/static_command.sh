#!/usr/bin/env bash
# static_command.sh COMMAND STATIC: STATIC asks for no loader and no library, and says what COMMAND says.
set -euo pipefail
if readelf --program-headers "$2" | grep -q INTERP; then
    echo "$2 is linked dynamically" >&2
    exit 1
fi
for arguments in 'certify radau_iia 3' 'tableau gauss 2 --digits 30' 'stability sdirk_alexander'; do
    diff <(env -i "$1" $arguments 2>&1) <(env -i "$2" $arguments 2>&1)
done
