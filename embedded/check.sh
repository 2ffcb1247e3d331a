#!/usr/bin/env bash
# Builds the firmware and plays it in an emulator: same bits as on the desktop and in WebAssembly, no panics, no doubles in f32, no heap, no
# formatting, instructions within the budget. With --all it prints the whole table of controllers, not only those with a budget.
#
# Needs qemu-system-arm, node, nm and size, and the targets named below. CARGO names a cargo that has them, if it is not the default one:
#   CARGO='cargo +nightly' embedded/check.sh
set -euo pipefail
cd "$(dirname "$0")"
cargo=${CARGO:-cargo}
board=thumbv7em-none-eabihf
web=wasm32-unknown-unknown
out=$PWD/target
export SUBJECT=nothing CARGO_TARGET_DIR=$out

qemu() {
  timeout 60 qemu-system-arm -machine mps2-an386 -cpu cortex-m4 -nographic -semihosting \
    -icount shift=6,sleep=off -kernel "$out/$board/release/$1" </dev/null
}
firmware() { $cargo build --quiet --locked --release --package firmware --target $board "$@"; }
host() { cargo run --quiet --locked --release --package host "$@"; }

# $1: folder of the precision, $2: features, $3: how far the functions of the platform may be off
same_bits() {
  local folder=$out/$1
  export RECORDINGS=$folder
  mkdir -p "$folder"
  host --features "$2" --bin record -- "$folder"
  host --features "$2" --bin play -- "$folder" >"$folder/desktop.txt"
  firmware --features "$2" --bin replay
  qemu replay >"$folder/board.txt"
  $cargo build --quiet --locked --release --package wasm --target $web --features "$2"
  node wasm/run.mjs "$out/$web/release/wasm.wasm" >"$folder/web.txt"
  cmp "$folder/desktop.txt" "$folder/board.txt"
  cmp "$folder/desktop.txt" "$folder/web.txt"
  echo "$1: $(wc -l <"$folder/desktop.txt") steps, the same bits on the desktop, on the board and in WebAssembly"
  host --no-default-features --features "$2" --bin play -- "$folder" >"$folder/platform.txt"
  echo -n "$1 without 'reproducible': "
  host --features "$2" --bin differences -- "$folder/desktop.txt" "$folder/platform.txt" "$3"
}

# $1: program, $2: pattern of symbols that it must not have, $3: what they are
without() {
  if nm "$out/$board/release/$1" | grep -E "$2"; then
    echo "$1 has $3"
    exit 1
  fi
}

echo '--- same bits'
same_bits f64 double 1e-11
firmware --features double --bin every
qemu every
same_bits f32 '' 1e-3

echo '--- no panic, no doubles, no heap, no formatting'
firmware --bin every --bin interrupt
qemu every
qemu interrupt
for program in replay every interrupt; do
  without $program '__aeabi_d(add|sub|rsub|mul|div|cmp)|__(add|sub|mul|div)df3' 'double precision in software'
  without $program '__rust_alloc|__rg_alloc|malloc' 'a heap'
  without $program 'core.*fmt' 'formatting'
done
if refused=$(firmware --features refused --bin refused 2>&1); then
  echo 'a path to a panic has linked'
  exit 1
fi
grep -q a_path_to_a_panic_is_linked <<<"$refused"
echo 'every controller, rule and source links without a path to a panic; a program with one does not'

echo '--- instructions, stack, memory, flash'
echo '| controller, f32 | instructions, mean | largest | stack in bytes | controller in bytes | flash in bytes |'
echo '|---|---|---|---|---|---|'
flash() { size "$out/$board/release/measure" | awk 'NR == 2 { print $1 + $2 }'; }
sed -n 's/^    "\(.*\)" =>.*/\1/p' firmware/src/bin/measure.rs | while read -r subject; do
  recording=/dev/null shown=${1:-}
  case $subject in
    # The yardstick, which is no part of the crate.
    *'by hand'*) budget=none shown=yes ;;
    *'N = 2, K = 3') budget=1500 ;;
    *'N = 3, K = 3') budget=3500 ;;
    *third-order*) budget=3500 recording=$RECORDINGS/third_order ;;
    *robot*) budget=none recording=$RECORDINGS/robot ;;
    *) budget=none ;;
  esac
  if [ $budget = none ] && [ "$subject" != nothing ] && [ -z "$shown" ]; then
    continue
  fi
  SUBJECT=$subject firmware --bin measure
  flash=$(($(flash) - $(wc -c <$recording)))
  if [ "$subject" = nothing ]; then
    nothing=$flash
    continue
  fi
  read -r mean most stack bytes <<<"$(qemu measure)"
  echo "| $subject | $mean | $most | $stack | $bytes | $((flash - nothing)) |"
  case $subject in
    'model-aided, boundary layer, N = 2, K = 3') composed=$mean ;;
    *'by hand'*)
      if [ $((100 * composed)) -gt $((103 * mean)) ]; then
        echo 'composed it takes more than 3 % more instructions than written by hand'
        exit 1
      fi
      ;;
  esac
  if [ $budget != none ] && [ "$most" -gt $budget ]; then
    echo "more than $budget instructions"
    exit 1
  fi
done
