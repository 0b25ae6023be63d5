# What each stage of `./mlab test` does: compile_STAGE makes what it needs, perhaps ahead of it (ahead.sh), stage_STAGE runs it;
# a stage has one of them or both. Each runs in a subshell with -e; its output goes to the stage's log.

jobs=$(job_count)

# Seeds of property tests differ from commit to commit, and are the same wherever one commit is tried.
seed_of_commit() {
  local hash
  hash=$(git -C "$root" rev-parse --short=12 HEAD 2>/dev/null) || hash=1
  echo $((16#$hash))
}
export RC_PARAMS="seed=$(seed_of_commit) ${RC_PARAMS-}"
# Sanitizers look at what is done, which the first examples of a property have done, too; all of them run in `unit`.
fewer_examples="$RC_PARAMS max_success=25"

# How many tests run at once where some wait for real time; and where most of them wait for each other most of the time.
waiting_jobs=$((jobs + (jobs + 1) / 2))
idle_jobs=$((3 * jobs))

# A test that fails only where the machine stands still for a moment is unsteady. A stage in which no more than these fail tries
# each once more, alone, and names those that pass then; but none that crashed, hung, or that a sanitizer spoke of.
unsteady_at_most=3

run_ctest() {
  local folder=$1 failed=$1/Testing/Temporary/LastTestsFailed.log said=$1/Testing/said names status=0
  shift
  mkdir -p "$folder/Testing"
  rm -f "$failed"
  local run=(ctest --test-dir "$folder" --output-on-failure --no-tests=ignore "${ctest_options[@]}")
  "${run[@]}" -j "$jobs" "$@" | tee "$said" && return
  [[ -f $failed ]] && (($(wc -l <"$failed") <= unsteady_at_most)) || return 1
  ! grep -qE '\*\*\*(Exception|Timeout)|Sanitizer: |libFuzzer: |runtime error: ' "$said" || return 1
  names=$(cut -d: -f2- "$failed")
  echo "$tried_again"
  "${run[@]}" -j 1 --rerun-failed && : >"$failed" || status=1
  { grep -vxFf <(cut -d: -f2- "$failed") <<<"$names" || true; } | sed "s/^/$unsteady /"
  return "$status"
}

configure_test() {
  configure "$build/test" -DCMAKE_BUILD_TYPE=Release -DMLAB_UNITY=ON -DMLAB_TESTS=ON "-DMLAB_WEB_FOLDER=$build/web"
}

# Compiled exactly as the product, so that what is tested is what runs, and the two share what ccache keeps.
compile_build() {
  configure_test
  ninja -C "$build/test" -j "$jobs"
}

stage_unit() { run_ctest "$build/test" -LE 'repo|e2e' -j "$waiting_jobs"; }
# web_scripts SCRIPT...: runs scripts of web/package.json, in the copy that the product's page is built in.
web_scripts() (
  source "$root/tools/web/node.sh"
  source "$root/tools/web/prepare.sh"
  mkdir -p "$build/web"
  exec 8>>"$build/web/lock"
  flock 8
  prepare_web "$root" "$build/web"
  exec 8>&-
  for script in "$@"; do NO_COLOR=1 npm run --silent "$script"; done
)

# editor_scripts SCRIPT...: runs scripts of editors/vscode/package.json in a copy of it, against the command that was built.
editor_scripts() (
  source "$root/tools/web/node.sh"
  source "$root/tools/web/prepare.sh"
  [[ -x $build/test/bin/mlab ]] || compile_build
  mkdir -p "$build/editors"
  exec 8>>"$build/editors/lock"
  flock 8
  prepare_editors "$root" "$build/editors"
  exec 8>&-
  for script in "$@"; do
    MLAB_ROOT=$root MLAB_COMMAND=$build/test/bin/mlab NO_COLOR=1 npm run --silent "$script"
  done
)

stage_web() {
  web_scripts check lint test
  editor_scripts check lint test
}
stage_browser() {
  install_peers tests/vehicles "$build/test/vehicle_peers" || echo "npm could not install vehicles (offline?); their test is skipped"
  MLAB_COMMAND=$build/test/bin/mlab MLAB_MISSIONS=$root/missions web_scripts browser
}
stage_repo() { run_ctest "$build/test" -L repo; }
# install_peers FOLDER TARGET: installs the packages of npm that tests of a folder run beside ours, where those look for them.
install_peers() (
  source "$root/tools/web/node.sh"
  find_node "$build/web"
  mkdir -p "$2"
  cd "$2"
  cmp -s "$root/$1/package-lock.json" node_modules/.installed-lock && exit 0
  cp "$root/$1"/{package.json,package-lock.json,.npmrc} .
  npm ci --prefer-offline --ignore-scripts --no-audit --no-fund --no-update-notifier && cp package-lock.json node_modules/.installed-lock
)

stage_e2e() {
  install_peers tests/exports "$build/test/scxml" ||
    echo "npm could not install the SCXML interpreter (offline?); its test is skipped"
  install_peers tests/mcap "$build/test/mcap_peers" || echo "npm could not install readers of MCAP (offline?); their tests are skipped"
  install_peers tests/vehicles "$build/test/vehicle_peers" || echo "npm could not install vehicles (offline?); their tests are skipped"
  run_ctest "$build/test" -L e2e -j "$idle_jobs"
}

# One build for the fuzzers and the sanitized unit tests. Optimised is only what they spend their time in (MLAB_BUSY_MODULES):
# all of it would take more than twice as long to compile.
configure_asan() {
  configure "$build/asan" -DCMAKE_CXX_COMPILER=clang++-19 -DCMAKE_BUILD_TYPE=Debug \
    "-DCMAKE_CXX_FLAGS_DEBUG=-O0 -g1 -D_GLIBCXX_ASSERTIONS" -DMLAB_UNITY=ON -DMLAB_TESTS=ON -DMLAB_FUZZ=ON \
    "-DMLAB_SANITIZE=address;undefined" "-DMLAB_FUZZ_SECONDS=$fuzz_seconds"
}

compile_fuzz() {
  configure_asan
  ninja -C "$build/asan" -j "$jobs" fuzzers
}
stage_fuzz() { run_ctest "$build/asan" -L fuzz; }

compile_address() {
  configure_asan
  ninja -C "$build/asan" -j "$jobs" unit_tests
}
stage_address() { RC_PARAMS=$fewer_examples run_ctest "$build/asan" -LE 'repo|e2e|fuzz' -j "$waiting_jobs"; }

compile_thread() {
  configure "$build/tsan" -DCMAKE_CXX_COMPILER=clang++-19 -DCMAKE_BUILD_TYPE=Debug "-DCMAKE_CXX_FLAGS_DEBUG=-O0 -g1" \
    -DMLAB_UNITY=ON -DMLAB_TESTS=ON -DMLAB_SANITIZE=thread
  ninja -C "$build/tsan" -j "$jobs" threaded_tests
}
stage_thread() { RC_PARAMS=$fewer_examples run_ctest "$build/tsan" -L threads -j "$waiting_jobs"; }

compile_tidy() {
  configure_test
  local limit=()
  ((tidy_seconds == 0)) || limit=(--seconds "$tidy_seconds")
  MLAB_JOBS=$jobs "$root/tools/tidy" -p "$build/test" "${limit[@]}"
}

stage_install() { bash "$root/tests/install/install_test" "$root" "$build/test"; }
