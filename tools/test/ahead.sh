# Compiles ahead. Tests mostly wait: for browsers, for robots in real time, for the longest of them. Meanwhile processors
# make what later stages need. What does so is of the idle class, so it gets a processor only where no test wants one.
# A stage that has come so far goes on where this was, with all that processors can give.
#
# What does not compile is told by its own stage, which tries once more.

ahead=         # the process, which leads a group; empty: nothing is compiled ahead
ahead_worked=0 # seconds that processors have worked for it

# begin_ahead STAGE...: compiles for those of these stages that need it, in their order.
begin_ahead() {
  [[ -z $ahead ]] || return 0
  local stage wanted=()
  for stage in "$@"; do
    ! declare -F "compile_$stage" >/dev/null || wanted+=("$stage")
  done
  ((${#wanted[@]} > 0)) || return 0
  set -m  # a group of its own, which can be ended as a whole
  (
    set +e +m
    trap 'exit 0' TERM
    trap 'count_work "$build/logs/ahead.worked"' EXIT
    chrt --idle --pid 0 "$BASHPID" || renice -n 19 -p "$BASHPID"
    for stage in "${wanted[@]}"; do "compile_$stage"; done
  ) >"$build/logs/ahead.log" 2>&1 </dev/null 9>&- &
  ahead=$!
  set +m
}

# Ends it, wherever it is.
end_ahead() {
  [[ -n $ahead ]] || return 0
  kill -- "-$ahead" 2>/dev/null || true
  wait "$ahead" 2>/dev/null || true
  ahead=
  ((ahead_worked += $(cat "$build/logs/ahead.worked" 2>/dev/null || echo 0))) || true
  rm -f "$build/logs/ahead.worked"
}
