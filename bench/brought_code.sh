#!/usr/bin/env bash
# What it costs that code which files bring runs in a process of its own: robots whose procedure the mission brings, and
# robots with the same procedure from the component library, in turns; then how soon robots with a new procedure move.
#
# usage: bench/brought_code.sh [MLAB [ROUNDS]]
set -euo pipefail
mlab=$(readlink -f "${1:-build/release/bin/mlab}")
rounds=${2:-7}
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"

cat >map.odl <<'END'
MISSION-AREA 20000 4000
CONTROL MEASURES:
AA Here 0 0 100 0 100 2000 0 2000
PP There 19000 1000
OBSTACLE 60 5 1
OBSTACLE 60 25 1
OBSTACLE 60 45 1
END

# network PROCEDURE >FILE: to the goal of the order, round obstacles, with a little noise.
network() {
  cat <<END
node goal is GetOrderGoal with nend
node way is DetectGoal with goal = goal; nend
node pull is MoveToGoal with goal = way; nend
node seen is DetectObstacles with range = 30; nend
node away is $1 with readings = seen; sphere = 10; safety_margin = 2; nend
node noise is Noise with persistence = 2; nend
node motion is WeightedSum with
  members = away; gains = 1;
  members = noise; gains = 0.1;
  members = pull; gains = 1;
nend
node wheels is Drive with v = motion; nend
END
}

# procedure NAME: what AvoidStaticObstacles of the library does.
procedure() {
  cat <<END
procedure Vector $1
with
  Obstacles readings;
  double [m] sphere = 30 in 0 .. 1e6;
  double [m] safety_margin = 5 in 0 .. 1e6;
header
body
  VectorSum sum;
  for (const auto& obstacle : readings) {
    const double inner = obstacle.radius + safety_margin;
    sum.add(repulsion(obstacle.center, length(obstacle.center), inner, inner + sphere));
  }
  output = sum.total();
pend
END
}

# mission NETWORK ROBOTS
mission() {
  printf 'OVERLAY map.odl\nNEW-ROBOT r "%s.cnl"\nUNIT <u>' "$1"
  for ((i = 0; i < $2; ++i)); do printf ' r'; done
  printf '\nCOMMAND LIST:\n0. UNIT u START Here 0 10\n1. UNIT u MOVETO There\n'
}

network AvoidStaticObstacles >library.cnl
{ procedure Mine && network Mine; } >brought.cnl

# speed NAME SECONDS: robot-cycles per second; where the robots are in the end stays in NAME.places.
speed() {
  "$mlab" run "$1.mdl" --headless --proceed --quiet --for "$2" --threads 1 --patience 100000 >out.txt 2>err.txt || {
    cat err.txt >&2
    exit 1
  }
  grep '^ *robot ' out.txt >"$1.places"
  sed -n 's/^done after.*(\([0-9]*\) robot-cycles per second)$/\1/p' out.txt
}
best() { sort -n | tail -n 1; }
middle() { sort -n | awk '{ all[NR] = $1 } END { print all[int((NR + 1) / 2)] }'; }

for robots in 100 4; do
  for name in library brought; do
    mission "$name" "$robots" >"$name.mdl"
    "$mlab" run "$name.mdl" --headless --proceed --for 1 >out.txt  # compiles
    : >"$name.speeds"
  done
  for ((round = 0; round < rounds; ++round)); do
    for name in library brought; do speed "$name" $((40000 / robots)) >>"$name.speeds"; done
  done
  # Both did the same, and something.
  cmp library.places brought.places
  grep -q 'drove [1-9]' library.places
  for name in library brought; do
    printf '%3d robots, procedure %-12s %8d robot-cycles/s at best, %8d in the middle of %d\n' "$robots" \
      "$([[ $name == library ]] && echo of the library || echo brought)" "$(best <$name.speeds)" "$(middle <$name.speeds)" "$rounds"
  done
  awk -v l="$(best <library.speeds)" -v b="$(best <brought.speeds)" -v n="$robots" \
    'BEGIN { printf "%3d robots: %.2f of the speed, %d cycles/s\n", n, b / l, b / n }'
done

for ((round = 0; round < 3; ++round)); do
  name=New$RANDOM$RANDOM
  { procedure "$name" && network "$name"; } >new.cnl
  mission new 4 >new.mdl
  TIMEFORMAT='a new procedure: the first simulated second is over after %R s (%U s of processor time)'
  { time "$mlab" run new.mdl --headless --proceed --quiet --for 1 >out.txt; } 2>&1
done
