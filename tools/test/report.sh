# One line per stage; at the end where the time went, and the closing line that counts all tests.

total_passed=0 total_failed=0 total_skipped=0
tried_again='Tried again:'  # in a log, before what ctest says of tests that it has told of already
unsteady='Unsteady:'        # before the name of a test that failed, and passed when it was tried again
unsteady_tests=()
stage_times=()  # per stage: name, seconds, seconds of processors

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
  read -r passed failed skipped < <(awk -v status="$2" -v again="^$tried_again" '
    $0 ~ again { is_again = 1 }
    /tests passed, [0-9]+ tests? failed out of [0-9]+/ {
      if (is_again) failed -= at_first
      else { total += $NF; at_first = $4 }
      failed += $4
      is_ctest = 1
    }
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

# count_work FILE: writes how many seconds processors have worked for all that was started by this shell and has ended.
count_work() {
  times >"$1.times"  # in this very shell: another would know nothing of its children
  awk 'NR == 2 { for (i = 1; i <= 2; i++) { split($i, part, /[ms]/); sum += 60 * part[1] + part[2] } printf "%d", sum }' \
    "$1.times" >"$1"
  rm -f "$1.times"
}

# run_part FUNCTION LOG: calls one part of a stage where there is it, and adds to `worked`.
run_part() {
  declare -F "$1" >/dev/null || return 0
  # In a subshell of its own, so that -e is in force inside.
  (set -e && trap 'count_work "$build/logs/worked"' EXIT && "$1") >>"$2" 2>&1
  local status=$?
  ((worked += $(<"$build/logs/worked")))
  return "$status"
}

# stages_after NAME: those that were chosen and are still to come.
stages_after() { printf '%s\n' "${stages[@]}" | sed "0,/^$1\$/d"; }

# run_stage NAME: does what there is to do for a stage, with its output in a log.
run_stage() {
  local name=$1 log=$build/logs/$1.log started=$SECONDS status=0 shaky watcher passed failed skipped worked=0
  : >"$log"
  watch_log "$name" "$log" 9>&- &
  watcher=$!
  ! declare -F "compile_$name" >/dev/null || end_ahead
  set +e
  run_part "compile_$name" "$log"
  status=$?
  if ((status == 0)); then
    # shellcheck disable=SC2046
    begin_ahead $(stages_after "$name")
    run_part "stage_$name" "$log"
    status=$?
  fi
  set -e
  stage_times+=("$name $((SECONDS - started)) $worked")
  kill "$watcher" 2>/dev/null || true
  wait "$watcher" 2>/dev/null || true
  end_progress
  count_tests "$log" "$status"
  mapfile -t shaky < <(sed -n "s/^$unsteady //p" "$log")
  unsteady_tests+=("${shaky[@]/#/$name: }")
  ((total_passed += passed, total_failed += failed, total_skipped += skipped)) || true
  ((failed + ${#shaky[@]} == 0)) || show_failure "$log"
  printf '%-8s %s  %5d passed, %d failed, %d skipped  %4d s\n' "$name" "$( ((failed == 0)) && echo ok || echo FAILED)" \
    "$passed" "$failed" "$skipped" $((SECONDS - started))
  # Without a build nothing else can be tested.
  ((status == 0)) || [[ $name != build ]] || report_all
}

# What each stage took, as seconds of the clock, as its share of the run, and as seconds that processors worked for it; and
# what they worked ahead of stages, while others waited.
report_times() {
  ((${#stage_times[@]} > 1)) || return 0
  ((ahead_worked == 0)) || stage_times+=("ahead 0 $ahead_worked")
  printf '%s\n' "${stage_times[@]}" | awk '
    { name[NR] = $1; seconds[NR] = $2; worked[NR] = $3; all += $2; all_worked += $3 }
    END {
      printf "\n%-8s %8s %6s %10s\n", "stage", "seconds", "share", "processor"
      for (i = 1; i <= NR; i++) printf "%-8s %8d %5.0f%% %10d\n", name[i], seconds[i], all ? 100 * seconds[i] / all : 0, worked[i]
      printf "%-8s %8d %6s %10d\n", "all", all, "", all_worked
    }'
}

report_all() {
  end_ahead
  report_times
  ((${#unsteady_tests[@]} == 0)) || printf '\n%s' 'Failed, and passed when tried again, so there is something to mend:' \
    "${unsteady_tests[@]/#/  }" ''
  printf '\n%d passed, %d failed, %d skipped\n' "$total_passed" "$total_failed" "$total_skipped"
  ((total_failed == 0)) || exit 1
  exit 0
}
