# Configures and builds one build folder: build/release, build/test, ...

# How many compilers at once: one per core, and a gigabyte of memory for each.
job_count() {
  local cores gigabytes
  cores=$(nproc)
  gigabytes=$(awk '/^MemAvailable/ { print int($2 / 1048576) }' /proc/meminfo)
  ((gigabytes >= 1)) || gigabytes=1
  echo $((cores < gigabytes ? cores : gigabytes))
}

# configure FOLDER OPTION...: where it was never configured, or with other options, or in another place.
configure() {
  local folder=$1 wanted had=
  shift
  wanted="$root $*"
  [[ ! -r $folder/launcher.options ]] || had=$(<"$folder/launcher.options")
  [[ $wanted != "$had" || ! -e $folder/build.ninja ]] || return 0
  # A cache of another place or of an interrupted configuration would only mislead.
  rm -rf "$folder/CMakeCache.txt" "$folder/CMakeFiles"
  mkdir -p "$folder"
  show_progress "mlab: configuring"
  if ! cmake -S "$root" -B "$folder" -G Ninja "$@" >"$folder/configure.log" 2>&1; then
    end_progress
    cat "$folder/configure.log" >&2
    give_up "could not configure the build; the output above is kept in $folder/configure.log"
  fi
  end_progress
  printf '%s' "$wanted" >"$folder/launcher.options"
}

# build_folder FOLDER TARGET...: with ninja's own line of progress on a terminal; else quiet until something fails.
build_folder() {
  local folder=$1 quiet=--quiet
  shift
  ! is_terminal || quiet=
  # shellcheck disable=SC2086
  NINJA_STATUS='mlab: building %p (%f of %t, %e s) ' ninja -C "$folder" $quiet -j "$(job_count)" "$@" >&2
}
