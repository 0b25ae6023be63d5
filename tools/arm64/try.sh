# Tries the package: in a Debian of its own, whose shell and dpkg are this machine's kind of program, what the package brings and
# depends on of the other kind, under QEMU. Sourced by tools/agent_arm64, which sets `root`, `build`, `folder` and `package`.

robot=$folder/robot
agent_programs=/usr/lib/missionlab-agent/bin

install_agent() {
  inside "$robot" dpkg --add-architecture arm64
  inside "$robot" apt-get -qq update
  cp "$package" "$robot/root/agent.deb"
  inside "$robot" apt-get -y -q --no-install-recommends --reinstall --allow-downgrades install /root/agent.deb
  inside "$robot" apt-get clean
  inside "$robot" dpkg --verify missionlab-agent
}

# The kernel starts no program of the other kind, so one that hands it to QEMU takes its name.
emulate_programs() {
  local name
  cp "$(command -v qemu-aarch64-static)" "$robot/usr/bin/"
  for name in mlab-agent mlab-robots; do
    mv "$robot$agent_programs/$name" "$robot$agent_programs/$name.arm64"
    printf '#!/bin/sh\nexec /usr/bin/qemu-aarch64-static -0 "$0" %s/%s.arm64 "$@"\n' "$agent_programs" "$name" \
      >"$robot$agent_programs/$name"
    chmod 755 "$robot$agent_programs/$name"
  done
}

fail() {
  end_progress
  say "$1"
  printf '      %s\n' "${@:2}" >&2
  exit 1
}

# The agent says what it is, and refuses what it does not know.
try_command_line() {
  local version status=0
  file -L "$robot$agent_programs/mlab-agent.arm64" "$robot$agent_programs/mlab-robots.arm64" | grep -vq "ARM aarch64" &&
    fail "the package's programs are not for 64-bit ARM"
  version=$(inside "$robot" mlab-agent --version) || fail "mlab-agent --version failed" "$version"
  [[ "mlab-agent $(dpkg-deb -f "$package" Version)" == "$version" ]] || fail "mlab-agent --version says $version"
  inside "$robot" mlab-agent --help | grep -q -- --config || fail "mlab-agent --help names no --config"
  inside "$robot" mlab-agent --no-such-option 2>/dev/null || status=$?
  [[ $status == 2 ]] || fail "mlab-agent --no-such-option ends with status $status, not 2"
  say "$version runs under QEMU"
}

# start_agent OPTION...: and waits until it is there.
start_agent() {
  inside "$robot" XDG_STATE_HOME=/var/lib/missionlab sh -c 'echo "$$" >/run/agent.pid && exec mlab-agent "$@"' sh \
    --fleet "$fleet" --name arm "$@" >"$folder/agent.log" 2>&1 &
  agent=$!
  carried=0
  local i
  for ((i = 0; i < 300; ++i)); do
    ! grep -q "waits for runs" "$folder/agent.log" || return 0
    kill -0 "$agent" 2>/dev/null || break
    sleep 0.1
  done
  fail "the agent does not come to wait for runs" "$(<"$folder/agent.log")"
}

stop_agent() {
  kill "$(<"$robot/run/agent.pid")"
  wait "$agent" || fail "the agent ended with status $?" "$(tail -n 5 "$folder/agent.log")"
  grep -q "has left the fleet" "$folder/agent.log" || fail "the agent did not say that it leaves" "$(tail -n 5 "$folder/agent.log")"
  # It was this one that computed.
  (($(grep -cE "and [1-9][0-9]* robots? with it" "$folder/agent.log") == carried)) ||
    fail "the agent did not carry robots of $carried runs" "$(<"$folder/agent.log")"
}

# mlab_here ARGUMENT...: this machine's command, which keeps what it keeps in the folder.
mlab_here() { XDG_STATE_HOME=$folder/state XDG_CACHE_HOME=$folder/cache "$build/release/bin/mlab" "$@"; }

# run_here MISSION NAME OPTION...: its report, but for how fast it was, in NAME.json; all that robots sensed and did in NAME.percepts.
run_here() {
  local file=$1 name=$folder/$2
  shift 2
  mlab_here run "$file" --headless --proceed --quiet --threads 1 --report "$name.json" --save-percepts "$name.percepts" \
    "$@" >"$name.log" 2>&1 || fail "the run failed: $file $*" "$(tail -n 20 "$name.log")" "$(tail -n 5 "$folder/agent.log")"
  sed -i '/^  "performance": {/,$d' "$name.json"
}

# try_mission FILE [OPTION...]: embedded, and on the agent with these options.
try_mission() {
  local mission=$1 started=$SECONDS kind
  shift
  show_progress "arm64: $mission"
  run_here "$root/$mission" embedded
  run_here "$root/$mission" emulated --robots fleet --fleet "$fleet" "$@"
  ((++carried))
  for kind in json percepts; do
    cmp -s "$folder/embedded.$kind" "$folder/emulated.$kind" ||
      fail "$mission: robots on ARM do something else" "$folder/embedded.$kind and $folder/emulated.$kind differ" \
        "$(diff "$folder/embedded.json" "$folder/emulated.json" | head -n 10)"
  done
  end_progress
  say "$mission${*:+ $*}: the same, bit for bit ($((SECONDS - started)) s)"
}

# What is not emulated is refused: QEMU knows neither Landlock nor the kernel's filter of system calls.
try_refusal() {
  local status=0
  mlab_here run "$root/$with_code" --headless --proceed --quiet --robots fleet --fleet "$fleet" >"$folder/refused.log" 2>&1 || status=$?
  [[ $status == 1 ]] && grep -q "this machine has nothing to make one of" "$folder/refused.log" && status=refused
  [[ $status == refused ]] || fail "code was not refused where there is no cell" "$(tail -n 20 "$folder/refused.log")"
  say "$with_code: refused, since there is no cell under QEMU"
}

# The agent calls g++, and gets one that makes the same in a fraction of the time.
install_cross_compiler() {
  inside "$robot" apt-get -y -q --no-install-recommends install g++-aarch64-linux-gnu libfmt-dev:arm64
  inside "$robot" apt-get clean
  ln -sf aarch64-linux-gnu-g++ "$robot/usr/bin/g++"
}

# Makes the fleet's keys, and gives the robot its own.
make_keys() {
  local kept=$robot/var/lib/missionlab/mlab/keys
  rm -rf "$folder/state" "$kept"
  mlab_here keys "$fleet"
  mlab_here keys "$fleet" --add arm
  mkdir -p "$kept/$fleet"
  mv "$folder/state/mlab/keys/$fleet/arm" "$kept/$fleet/own"
}

try_package() {
  local mission
  fleet=arm64-$RANDOM$RANDOM
  with_code=docs/examples/own_behavior/mine.mdl
  step "a Debian for the package" make_machine "$robot" ca-certificates
  step "installing the package" install_agent
  emulate_programs
  try_command_line

  start_agent
  for mission in "$root"/missions/*/*.mdl; do try_mission "${mission#"$root/"}"; done
  try_refusal
  stop_agent

  step "a compiler for what missions bring" install_cross_compiler
  start_agent --no-cell
  try_mission "$with_code"
  stop_agent

  step "keys of a secured fleet" make_keys
  start_agent --secure
  try_mission missions/patrol/patrol.mdl --secure
  stop_agent
}
