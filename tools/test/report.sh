# One line per stage, and the closing line that counts all tests.

total_passed=0 total_failed=0 total_skipped=0

# Shows how far a stage is, from the last line of its log, until it is killed. Only on a terminal.
watch_log() {
  is_terminal || return 0
  local name=$1 log=$2 started=$SECONDS line
  while sleep 1; do
    line=$(tail -c 400 "$log" 2>/dev/null | tr '\r' '\n' | grep -v '^$' | tail -n 1)
    show_progress "$(printf '%-8s %4d s  %s' "$name" $((SECONDS - started)) "$line" | cut -c "1-${COLUMNS:-100}")"
  done
}

# count_tests LOG STATUS: sets passed, failed, skipped from what ctest and vitest say in the log; a stage without them is
# one test. vitest: `Tests  1 failed | 41 passed | 2 skipped (44)`.
count_tests() {
  read -r passed failed skipped < <(awk -v status="$2" '
    /tests passed, [0-9]+ tests? failed out of [0-9]+/ { failed += $4; total += $NF; is_ctest = 1 }
    /^Test project / { is_ctest = 1 }
    /^ *Tests  .*\([0-9]+\)$/ {
      is_ctest = 1
      for (i = 2; i <= NF; i++) {
        if ($i ~ /^passed/) total += $(i - 1)
        if ($i ~ /^failed/) { failed += $(i - 1); total += $(i - 1) }
        if ($i ~ /^(skipped|todo)/) { skipped += $(i - 1); total += $(i - 1) }
      }
    }
    /Not Run \(Disabled\)|\*\*\*Skipped/ { skipped++ }
    END {
      if (!is_ctest) print (status == 0), (status != 0), 0
      else print total - failed - skipped, (status != 0 && failed == 0) ? 1 : failed + 0, skipped + 0
    }' "$1")
}

# What of a failed stage a person wants to see: what compilers, ctest and sanitizers say, not the progress.
show_failure() { grep -v -E '^\[[0-9]+/[0-9]+\]|Test +#[0-9]+: .* Passed|^ +Start +[0-9]+:' "$1" | tail -n 150; }

# run_stage NAME: calls stage_NAME with its output in a log.
run_stage() {
  local name=$1 log=$build/logs/$1.log started=$SECONDS status=0 watcher passed failed skipped
  : >"$log"
  watch_log "$name" "$log" 9>&- &
  watcher=$!
  # In a subshell of its own, so that -e is in force inside.
  set +e
  (set -e && "stage_$name") >>"$log" 2>&1
  status=$?
  set -e
  kill "$watcher" 2>/dev/null || true
  wait "$watcher" 2>/dev/null || true
  end_progress
  count_tests "$log" "$status"
  ((total_passed += passed, total_failed += failed, total_skipped += skipped)) || true
  ((failed == 0)) || show_failure "$log"
  printf '%-8s %s  %5d passed, %d failed, %d skipped  %4d s\n' "$name" "$( ((failed == 0)) && echo ok || echo FAILED)" \
    "$passed" "$failed" "$skipped" $((SECONDS - started))
  # What a stage had no time for is no failure, but it is not hidden.
  grep 'are left: the time is up' "$log" || true
  # Without a build nothing else can be tested.
  ((status == 0)) || [[ $name != build ]] || report_all
}

report_all() {
  printf '\n%d passed, %d failed, %d skipped\n' "$total_passed" "$total_failed" "$total_skipped"
  ((total_failed == 0)) || exit 1
  exit 0
}
