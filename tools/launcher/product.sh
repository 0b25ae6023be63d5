# Makes build/release current: packages, configuration, build. Sourced by the launcher, which sets `root`, `build`,
# `binary`, `stamp`, `web_stamp`, `python_stamp` and `wants_web`.

source "$root/tools/launcher/messages.sh"
source "$root/tools/launcher/packages.sh"
source "$root/tools/launcher/build.sh"

make_product_current() {
  mkdir -p "$build/release" 2>/dev/null && [[ -w $build/release ]] ||
    give_up "has to build, but can't write to $build" \
      "copy or clone the project to a place of your own, or say where to build: MLAB_BUILD_DIR=DIR ./mlab ..."
  wait_for_lock
  is_current || build_product  # current: another launcher built it meanwhile
  exec 9>&-
}

build_product() {
  local started=$SECONDS is_first=
  [[ -x $binary ]] || is_first=1
  find_product_packages
  ensure_packages "${product_packages[@]}"
  [[ -z $is_first ]] || say "builds for the first time, which takes some minutes"
  [[ -n $is_first ]] || is_terminal || say "builds what changed"
  [[ -z $wants_web ]] || is_web_current || start_web
  is_binary_current || build_binary
  finish_web
  [[ -z $is_first ]] || say "built in $((SECONDS - started)) s"
}

build_binary() {
  # The stamp is as old as the start of the build: what is edited meanwhile is newer.
  printf '%s\n' "$root" >"$stamp.new"
  configure_release
  build_folder "$build/release" mlab mlab-agent || give_up "the build failed; what the compiler said stands above"
  [[ -x $binary ]] || give_up "the build made no $binary"
  mv -f "$stamp.new" "$stamp"
}

# The Python module, in build/release/python, for who asks for it with `./mlab python`.
make_python_current() {
  mkdir -p "$build/release" 2>/dev/null && [[ -w $build/release ]] ||
    give_up "has to build, but can't write to $build" \
      "copy or clone the project to a place of your own, or say where to build: MLAB_BUILD_DIR=DIR ./mlab ..."
  wait_for_lock
  is_python_current || build_python
  exec 9>&-
}

build_python() {
  find_product_packages
  ensure_packages "${product_packages[@]}" "$root/tools/packages/python.txt"
  if [[ -e $python_stamp ]]; then say "builds what changed"; else say "builds the Python module for the first time, which takes some minutes"; fi
  printf '%s\n' "$root" >"$python_stamp.new"
  configure_release
  # A folder that was configured before the packages were there does not know of it yet.
  grep -qs mlab_python "$build/release/build.ninja" ||
    cmake -S "$root" -B "$build/release" >"$build/release/configure.log" 2>&1 ||
    give_up "could not configure the build; what was said is kept in $build/release/configure.log"
  build_folder "$build/release" mlab_python || give_up "the build failed; what the compiler said stands above"
  mv -f "$python_stamp.new" "$python_stamp"
}

configure_release() {
  configure "$build/release" -DCMAKE_BUILD_TYPE=Release -DMLAB_UNITY=ON -DMLAB_TESTS=OFF "-DMLAB_WEB_FOLDER=$build/web"
}

# The page is built beside the compiler, mostly waiting for the network. Where that fails everything but the console
# works all the same: `mlab` finds the reason in web_missing.txt, and the next call tries again.
web_process=
start_web() {
  printf '%s\n' "$root" >"$web_stamp.new"
  # A group of its own: one signal ends npm and all that it started.
  set -m
  bash "$root/tools/web/build" "$build/web" "$build/release/share/mlab/web" >"$build/release/web.log" 2>&1 9>&- &
  web_process=$!
  set +m
  trap 'kill -- "-$web_process" 2>/dev/null' EXIT
}

finish_web() {
  [[ -n $web_process ]] || return 0
  local missing=$build/release/share/mlab/web_missing.txt
  show_progress "mlab: building the page of the console"
  if wait "$web_process"; then
    rm -f "$missing"
    mv -f "$web_stamp.new" "$web_stamp"
  else
    mkdir -p "${missing%/*}"
    cp "$build/release/web.log" "$missing"
  fi
  end_progress
  trap - EXIT
}

# One launcher at a time builds; the lock goes with the process, however it ends.
wait_for_lock() {
  exec 9>>"$build/launcher.lock"
  flock -n 9 || {
    say "waits for another ./mlab that builds here"
    flock 9
  }
}
