# Which Node builds the web client: the system's where it is new enough, else one of its own from npm.

node_wanted=20.19  # the oldest that the web's tools run on
node_pinned=20.20.2

# is_node_current NODE: true where it is at least node_wanted.
is_node_current() {
  local version
  version=$("$1" -p process.versions.node 2>/dev/null) || return 1
  [[ $(printf '%s\n' "$node_wanted" "$version" | sort -V | head -n 1) == "$node_wanted" ]]
}

# find_node FOLDER: puts a Node that is new enough first in PATH; the one from npm is kept in FOLDER/node.
find_node() {
  local own=$1/node
  command -v npm >/dev/null || { echo "there is no npm here; ./mlab installs it, or: apt-get install nodejs npm" >&2 && return 1; }
  ! is_node_current node || return 0
  if ! is_node_current "$own/node_modules/node/bin/node"; then
    mkdir -p "$own"
    # A package of its own, so that npm does not look for one in the folders above.
    echo '{"private": true}' >"$own/package.json"
    npm install --prefix "$own" --no-audit --no-fund --no-save --no-update-notifier "node@$node_pinned" || {
      echo "node is older than $node_wanted, and npm could not install node@$node_pinned (offline?)" >&2
      return 1
    }
  fi
  export PATH="$own/node_modules/node/bin:$PATH"
}
