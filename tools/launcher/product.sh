# Makes build/release current: packages, configuration, build. Sourced by the launcher, which sets `root`, `build`,
# `binary` and `stamp`.

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
  # The stamp is as old as the start of the build: what is edited meanwhile is newer.
  printf '%s\n' "$root" >"$stamp.new"
  [[ -z $is_first ]] || say "builds for the first time, which takes some minutes"
  [[ -n $is_first ]] || is_terminal || say "builds what changed"
  configure "$build/release" -DCMAKE_BUILD_TYPE=Release -DMLAB_UNITY=ON -DMLAB_TESTS=OFF "-DMLAB_WEB_FOLDER=$build/web"
  build_folder "$build/release" all || give_up "the build failed; what the compiler said stands above"
  [[ -x $binary ]] || give_up "the build made no $binary"
  mv -f "$stamp.new" "$stamp"
  [[ -z $is_first ]] || say "built in $((SECONDS - started)) s"
}

# One launcher at a time builds; the lock goes with the process, however it ends.
wait_for_lock() {
  exec 9>>"$build/launcher.lock"
  flock -n 9 || {
    say "waits for another ./mlab that builds here"
    flock 9
  }
}
