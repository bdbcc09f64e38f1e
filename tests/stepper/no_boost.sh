#!/usr/bin/env bash
# no_boost.sh COMPILER SOURCE EIGEN: every header a stepper program reads, and none of them from boost/.
set -eu
set -o pipefail
read_files() { # CODE: the files the preprocessor opens
    printf '%s\n' "$1" | "$compiler" -std=c++20 -x c++ -E -I "$source/include" -I "$source/tableaux" -I "$eigen" - |
        sed -n 's/^# [0-9]* "\([^"]*\)".*/\1/p' | sort -u
}
compiler=$1 source=$2 eigen=$3
stepper=$(read_files '#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>')
grep -q 'stagecraft/integrate.hpp' <<<"$stepper" || { echo "the stepper was not read"; exit 1; }
if grep '/boost/' <<<"$stepper"; then echo "boost/ headers in a stepper program"; exit 1; fi
# The check can fail: a program with exact arithmetic does read boost/.
grep -q '/boost/' <<<"$(read_files '#include <stagecraft/tableaux/rational.hpp>')" ||
    { echo "the check sees no boost/ header where there are some"; exit 1; }
