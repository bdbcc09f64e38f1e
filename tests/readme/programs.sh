#!/usr/bin/env bash
# programs.sh COMPILER SOURCE WORK PAGE INCLUDE...: every C++ block of the page compiles as shown and runs; where a text
# block follows it, that is what it prints. A block without main() is a part of the program that the next block with one
# ends. The first program gets along with include/ and Eigen.
set -euo pipefail
compiler=$1 source=$2 work=$3 page=$4
shift 4
rm -rf "$work"
mkdir -p "$work"
awk -v dir="$work" '
    /^```cpp$/ { if (!open) ++n; open = 1; file = dir "/program" n ".cpp"; next }
    /^```text$/ { file = dir "/program" n ".txt"; next }
    /^```/ { file = ""; next }
    file != "" { print >file; if (/^int main\(/) open = 0 }
    END { if (open) { print "the last C++ block has no main()"; exit 1 } }' "$source/$page"
test -s "$work/program1.cpp" && test -s "$work/program1.txt"
roots=(-I"$source/include")
cheap=()  # g++ spends a tenth of its time on garbage unless it is told not to (CMakeLists.txt)
! "$compiler" --version | grep -q 'Free Software' || cheap=(--param=ggc-min-heapsize=1048576)
for program in "$work"/program*.cpp; do
    name=${program%.cpp}
    "$compiler" -std=c++20 -O0 "${cheap[@]}" "${roots[@]}" "${@/#/-I}" "$program" -o "$name"
    "$name" >"$name.printed"
    [ ! -e "$name.txt" ] || diff "$name.txt" "$name.printed"
    roots=(-I"$source/include" -I"$source/tableaux" -I"$source/theory")
done
