#!/usr/bin/env bash
# What batches cost: processor time and memory of 200 runs of Demo C with table and page; of many, on all processors, to the
# sum of single runs, which is taken from a thousand on one thread.
#
# usage: bench/batch.sh [MLAB [MANY]]
set -euo pipefail
root=$(cd "$(dirname "$(readlink -f -- "${BASH_SOURCE[0]}")")/.." && pwd)
mlab=$(readlink -f "${1:-$root/build/release/bin/mlab}")
many=${2:-10000}
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
mission=$root/missions/demo_c/demo_c.mdl
cores=$(nproc)

# measure NAME COMMAND...: prints wall clock and processor time [s], and the most memory [MB]; leaves the processor time in $cpu.
measure() {
  local name=$1 status=0 memory=0 now TIMEFORMAT='%R %U %S'
  shift
  { time run_watched "$@"; } 2>times
  read -r status memory <watched
  local wall user system
  read -r wall user system < <(tail -n 1 times)
  cpu=$(awk "BEGIN { printf \"%.2f\", $user + $system }")
  printf '%-32s %8s s  %8s s of processors  %5d MB%s\n' "$name" "$wall" "$cpu" $((memory / 1024)) \
    "$([[ $status == 0 ]] || echo "  exit status $status")"
}
run_watched() {
  local status=0 memory=0 now
  "$@" >/dev/null </dev/null &
  while kill -0 $! 2>/dev/null; do
    now=$(awk '/VmHWM/ { print $2 }' "/proc/$!/status" 2>/dev/null) || true
    memory=${now:-$memory}
    sleep 0.2
  done
  wait $! || status=$?
  echo "$status $memory" >watched
}

ratio() { awk "BEGIN { printf \"%.2f\", $1 / $2 }"; }

measure "200 runs, table and page" "$mlab" batch "$mission" --runs 200 --table a.csv --html a.html
two_hundred=$cpu
measure "a batch of one run" "$mlab" batch "$mission" --runs 1 --table b.csv --html b.html
start=$cpu
measure "1000 runs, one thread" "$mlab" batch "$mission" --runs 1000 --threads 1
single=$cpu
measure "$many runs, $cores threads" "$mlab" batch "$mission" --runs "$many" --table c.csv --html c.html
all=$cpu
echo "200 runs on two idle processors: $(ratio "$two_hundred" 2) s (a batch takes $start s to begin and end)"
echo "$many runs to the sum of single ones: $(ratio "$all" "($single * $many / 1000)")"
