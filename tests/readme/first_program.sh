#!/usr/bin/env bash
# first_program.sh COMPILER EIGEN SOURCE BUILD: the README's first C++ program compiles as shown, with nothing but
# include/ and Eigen, and prints what the README says it prints.
set -euo pipefail
compiler=$1 eigen=$2 source=$3 work=$4/readme
mkdir -p "$work"
block() { awk -v fence="\`\`\`$1" '$0 == fence { on = 1; next } /^```/ { if (on) exit } on' "$source/README.md"; }
block cpp >"$work/main.cpp"
block text >"$work/expected.txt"
test -s "$work/main.cpp" && test -s "$work/expected.txt"
"$compiler" -std=c++20 -O1 -I"$source/include" -I"$eigen" "$work/main.cpp" -o "$work/program"
"$work/program" >"$work/printed.txt"
diff "$work/expected.txt" "$work/printed.txt"
