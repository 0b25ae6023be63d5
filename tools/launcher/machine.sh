# Makes other Debians in folders. Sourced by tools that are root, and in a mount namespace of their own: what is mounted here goes
# with it, however the tool ends.

# This machine's own sources of Debian, a line each: URI SUITE CODENAME.
debian_sources() {
  apt-get indextargets --format '$(ORIGIN) $(REPO_URI) $(SUITE) $(CODENAME)' 'Created-By: Packages' |
    awk '$1 == "Debian" { print $2, $3, $4 }' | sort -u
}

# make_machine FOLDER PACKAGES: a minimal Debian 12 that reaches the mirror as this machine does, with these packages too (their
# names with commas). One that was made before is used again. What debootstrap said stands in FOLDER.log.
make_machine() {
  local machine=$1 packages=$2 mirror
  mirror=$(debian_sources | awk '$3 == "bookworm" { print $1; exit }')
  [[ -n $mirror ]] || give_up "this machine's apt knows no Debian 12 to make another from; try apt-get update"
  if [[ ! -e $machine/etc/machine.is_made ]]; then
    rm -rf --one-file-system "$machine"
    debootstrap --variant=minbase --include="$packages" bookworm "$machine" "$mirror" >"$machine.log" 2>&1 ||
      give_up "debootstrap failed; its log is $machine.log" "$(tail -n 3 "$machine.log")"
    touch "$machine/etc/machine.is_made"
  fi
  debian_sources | awk '{ print "deb", $1, $3, "main" }' | sort -u >"$machine/etc/apt/sources.list"
  apt-config dump | grep -E '^Acquire::(http|https|Check)' >"$machine/etc/apt/apt.conf.d/90this-machine" || true
  cp -L /etc/resolv.conf /etc/hosts "$machine/etc/" 2>/dev/null || true
  mount -t proc proc "$machine/proc"
  mount --rbind /dev "$machine/dev"
}

# inside MACHINE COMMAND...: as its root, with nothing of this one's environment but how to reach the mirror.
inside() {
  local machine=$1
  shift
  chroot "$machine" /usr/bin/env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LANG=C.UTF-8 TERM=dumb \
    DEBIAN_FRONTEND=noninteractive \
    ${http_proxy:+http_proxy="$http_proxy"} ${https_proxy:+https_proxy="$https_proxy"} "$@"
}
