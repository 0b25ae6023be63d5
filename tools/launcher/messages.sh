# How the launcher speaks: on standard error, so that what `mlab` prints can be piped.

say() { printf 'mlab: %s\n' "$*" >&2; }

# Says why nothing can be done, one line per argument, and ends with the status of a failed set-up.
give_up() {
  say "$1"
  shift
  (($# == 0)) || printf '      %s\n' "$@" >&2
  exit 2
}

is_terminal() { [[ -t 2 && ${TERM:-dumb} != dumb ]]; }

# Shows a line that the next one replaces. Nothing where standard error is no terminal.
show_progress() { ! is_terminal || printf '\r\033[K%s' "$*" >&2; }
end_progress() { ! is_terminal || printf '\r\033[K' >&2; }
