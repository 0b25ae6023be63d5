# Installs the Debian packages of tools/packages/*.txt that are missing.

# Sets `product_packages` to the lists for building and running the product. Node and npm are needed for the page of the
# console alone (`wants_web`). A machine that has them from elsewhere keeps them: Debian's would take their place.
find_product_packages() {
  product_packages=("$root/tools/packages/run.txt")
  [[ -n $wants_web ]] || return 0
  command -v node >/dev/null && command -v npm >/dev/null || product_packages+=("$root/tools/packages/node.txt")
}

# missing_packages LIST...: the lines of the lists whose package is not installed.
missing_packages() {
  local installed
  installed=$(dpkg-query -W -f '${binary:Package} ${db:Status-Status}\n' 2>/dev/null |
    awk '$2 == "installed" { sub(/:.*/, "", $1); print $1 }')
  awk 'NR == FNR { installed[$1]; next } !/^#/ && NF && !($1 in installed)' <(printf '%s\n' "$installed") "$@"
}

# Sets `as_root` to the words that run a command as root; false where there is no way.
find_root() {
  as_root=()
  ((EUID == 0)) && return
  command -v sudo >/dev/null || return 1
  if sudo -n true 2>/dev/null; then as_root=(sudo -n); elif [[ -t 0 ]] && is_terminal; then as_root=(sudo); else return 1; fi
}

apt() { LC_ALL=C DEBIAN_FRONTEND=noninteractive "${as_root[@]}" apt-get "$@"; }

# apt_install LOG PACKAGE...: shows how far it is; the rest goes to the log. (sudo hands on no other descriptors than
# the first three, so the fourth is opened on its other side.)
apt_install() {
  local log=$1
  shift
  LC_ALL=C DEBIAN_FRONTEND=noninteractive "${as_root[@]}" sh -c 'exec 4>&1 >>"$0" 2>&1; exec apt-get -y \
    --no-install-recommends --no-remove -o Dpkg::Use-Pty=0 -o DPkg::Lock::Timeout=300 -o APT::Status-Fd=4 \
    install "$@"' "$log" "$@" </dev/null | show_apt_progress
}

# Reads apt's status lines: `dlstatus:1:40.0:Retrieving`, `pmstatus:cmake:40.0:Unpacking cmake`.
show_apt_progress() {
  local line
  while read -r line; do
    [[ $line =~ ^(dl|pm)status:(.*):([0-9]+)\.[0-9]*: ]] || continue
    case ${BASH_REMATCH[1]} in
      dl) show_progress "mlab: downloading ${BASH_REMATCH[3]}%" ;;
      pm) show_progress "mlab: installing ${BASH_REMATCH[3]}% (${BASH_REMATCH[2]})" ;;
    esac
  done
  end_progress
}

# ensure_packages LIST...: installs what is missing, or gives up with the command that a person has to type.
ensure_packages() {
  [[ -z ${MLAB_SKIP_PACKAGES-} ]] || return 0
  local lines names by_hand log simulation removed
  if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
    say "this is not a Debian system, so the packages it needs are not looked for:"
    grep -hv '^#' "$@" | sed 's/^/        /' >&2
    give_up "install their like by hand, then set MLAB_SKIP_PACKAGES=1"
  fi
  lines=$(missing_packages "$@")
  [[ -n $lines ]] || return 0
  mapfile -t names < <(awk '{ print $1 }' <<<"$lines")
  by_hand="apt-get install --no-install-recommends ${names[*]}"

  say "installs ${#names[@]} Debian packages that are missing:"
  sed 's/^/        /' <<<"$lines" >&2
  find_root || give_up "that takes root, and no sudo works here without a password; as root, run" "$by_hand"

  log=$(mktemp)
  simulation=$(apt -s --no-install-recommends install "${names[@]}" 2>&1) || {
    say "fetches the list of packages"
    apt -qq update >"$log" 2>&1 || true
    simulation=$(apt -s --no-install-recommends install "${names[@]}" 2>&1) || {
      grep -E '^[EW]:|Unable|Depends' <<<"$simulation" | sed 's/^/        /' >&2
      give_up "apt-get knows no way to install them (offline, or not Debian 12?); where it does, run as root" \
        "apt-get update && $by_hand"
    }
  }
  removed=$(awk '/^Remv / { print $2 }' <<<"$simulation" | paste -sd' ')
  [[ -z $removed ]] || give_up "installing them would remove $removed, so nothing was done; to have it so, run as root" "$by_hand"

  local started=$SECONDS
  if ! apt_install "$log" "${names[@]}"; then
    # The lists may be older than what the mirror still has.
    apt -qq update >>"$log" 2>&1 || true
    apt_install "$log" "${names[@]}" || {
      grep -E '^[EW]:|Err:|Failed' "$log" | tail -n 8 | sed 's/^/        /' >&2
      give_up "apt-get could not install them (is this machine offline?); the whole log is $log; by hand, as root" "$by_hand"
    }
  fi
  rm -f "$log"
  say "installed in $((SECONDS - started)) s"
}
