# Makes the package: compilers for the other architecture in a Debian of their own, so that this machine's libraries stay as they
# are. Sourced by tools/agent_arm64, which sets `root`, `build` and `folder`.

compilers=$folder/compilers

# step TITLE COMMAND...: one of the tool's steps, what it prints in a log of its own.
step() {
  local title=$1 log=$folder/${1// /_}.log started=$SECONDS status
  shift
  show_progress "arm64: $title"
  # Not behind `||` or `if`, where the shell would go on after what fails.
  set +e
  (set -e && "$@") >"$log" 2>&1 </dev/null
  status=$?
  set -e
  end_progress
  ((status == 0)) || {
    tail -n 30 "$log" >&2
    give_up "failed: $title; the whole log is $log"
  }
  say "$title: $((SECONDS - started)) s"
}

# Libraries and headers are the other architecture's, programs this one's.
compiler_packages() {
  awk '!/^#/ && NF { print $1 }' "$root/tools/packages/run.txt" | while read -r name; do
    case $name in
      *-dev) echo "$name:arm64" ;;
      g++) echo crossbuild-essential-arm64 ;;
      mold) ;;  # it would take a name that GCC looks for
      *) echo "$name" ;;
    esac
  done
  # What this machine's cnlc runs with; what cpack looks into programs with.
  echo libfmt9 libseccomp2 file
}

install_compilers() {
  inside "$compilers" dpkg --add-architecture arm64
  inside "$compilers" apt-get -qq update
  # shellcheck disable=SC2046
  inside "$compilers" apt-get -y -q --no-install-recommends install $(compiler_packages)
  inside "$compilers" apt-get clean
}

# The sources can only be read there, and this machine's build is where cnlc is.
show_sources() {
  mkdir -p "$compilers"/{source,native,compiled} "$folder/compiled"
  mount --bind "$root" "$compilers/source"
  mount -o remount,bind,ro "$compilers/source"
  mount --bind "$build/release/bin" "$compilers/native"
  mount -o remount,bind,ro "$compilers/native"
  mount --bind "$folder/compiled" "$compilers/compiled"
}

# compile COMMAND...: there, after those who work on this machine.
compile() { inside "$compilers" CCACHE_DIR=/compiled/ccache nice -n 10 "$@"; }

configure_agent() {
  compile cmake -S /source -B /compiled/agent -G Ninja --toolchain /source/cmake/aarch64-linux-gnu.cmake \
    -DCMAKE_BUILD_TYPE=Release -DMLAB_UNITY=ON -DMLAB_TESTS=OFF -DMLAB_WEB=OFF -DMLAB_CNLC=/native/cnlc \
    -DCMAKE_SKIP_INSTALL_ALL_DEPENDENCY=ON
}

build_agent() {
  local started=$SECONDS quiet=--quiet
  ! is_terminal || quiet=
  # shellcheck disable=SC2086
  compile env TERM="${TERM-dumb}" NINJA_STATUS='arm64: building %p (%f of %t, %e s) ' \
    ninja -C /compiled/agent $quiet -j "$(job_count)" mlab-agent mlab-robots >&2 ||
    give_up "the build failed; what the compiler said stands above"
  say "building: $((SECONDS - started)) s"
}

# What a package depends on is looked up among the libraries of the architecture that these variables name.
pack_agent() {
  rm -rf "$folder/compiled/package"
  compile sh -c 'cd /compiled/agent && export $(dpkg-architecture -a arm64 -f 2>/dev/null) &&
    exec cpack -G DEB -B /compiled/package -D CPACK_COMPONENTS_ALL=agent'
  rm -f "$folder"/missionlab-agent_*_arm64.deb
  mv "$folder"/compiled/package/missionlab-agent_*_arm64.deb "$folder/"
}

make_package() {
  step "a Debian for compilers" make_machine "$compilers" ca-certificates
  step "compilers and libraries" install_compilers
  show_sources
  step "configuring" configure_agent
  build_agent
  step "packing" pack_agent
  package=$(echo "$folder"/missionlab-agent_*_arm64.deb)
  echo "$package"
}
