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

start_agent() {
  fleet=arm64-$RANDOM$RANDOM
  inside "$robot" XDG_STATE_HOME=/var/lib/missionlab sh -c 'echo "$$" >/run/agent.pid && exec mlab-agent "$@"' sh \
    --fleet "$fleet" --name arm >"$folder/agent.log" 2>&1 &
  agent=$!
  local i
  for ((i = 0; i < 300; ++i)); do
    ! grep -q "waits for runs" "$folder/agent.log" || return 0
    kill -0 "$agent" 2>/dev/null || break
    sleep 0.1
  done
  fail "the agent does not come to wait for runs" "$(<"$folder/agent.log")"
}

# run_here MISSION NAME OPTION...: its report, but for how fast it was, in NAME.json; all that robots sensed and did in NAME.percepts.
run_here() {
  local file=$1 name=$folder/$2
  shift 2
  "$build/release/bin/mlab" run "$file" --headless --proceed --quiet --threads 1 --report "$name.json" --save-percepts "$name.percepts" \
    "$@" >"$name.log" 2>&1 || fail "the run failed: $file $*" "$(tail -n 20 "$name.log")" "$(tail -n 5 "$folder/agent.log")"
  sed -i '/^  "performance": {/,$d' "$name.json"
}

try_mission() {
  local mission=$1 file=$root/missions/$1/$1.mdl started=$SECONDS kind
  show_progress "arm64: missions/$mission"
  run_here "$file" embedded
  run_here "$file" emulated --robots fleet --fleet "$fleet"
  for kind in json percepts; do
    cmp -s "$folder/embedded.$kind" "$folder/emulated.$kind" ||
      fail "missions/$mission: robots on ARM do something else" "$folder/embedded.$kind and $folder/emulated.$kind differ" \
        "$(diff "$folder/embedded.json" "$folder/emulated.json" | head -n 10)"
  done
  end_progress
  say "missions/$mission: the same, bit for bit ($((SECONDS - started)) s)"
}

try_package() {
  step "a Debian for the package" make_machine "$robot" ca-certificates
  step "installing the package" install_agent
  emulate_programs
  try_command_line
  start_agent
  for mission in "$root"/missions/*/; do try_mission "$(basename "$mission")"; done
  kill "$(<"$robot/run/agent.pid")"
  wait "$agent" || fail "the agent ended with status $?" "$(tail -n 5 "$folder/agent.log")"
  grep -q "has left the fleet" "$folder/agent.log" || fail "the agent did not say that it leaves" "$(tail -n 5 "$folder/agent.log")"
}
