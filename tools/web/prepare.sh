# A copy of the web client's sources in a folder of the build, with the packages that it needs: the source tree may be
# read-only, and builds with other options share it.

# prepare_web SOURCE FOLDER: afterwards FOLDER/web can run npm's scripts.
prepare_web() {
  local source=$1 folder=$2
  mkdir -p "$folder/web"
  copy_tree "$source/web" "$folder/web"
  mkdir -p "$folder/proto" && copy_tree "$source/proto" "$folder/proto"
  mkdir -p "$folder/tests/browser" && copy_tree "$source/tests/browser" "$folder/tests/browser"
  find_node "$folder"
  cd "$folder/web"
  install_locked "the web client"
}

# prepare_editors SOURCE FOLDER: afterwards FOLDER/vscode can run the extension's scripts.
prepare_editors() {
  local source=$1 folder=$2
  mkdir -p "$folder/vscode"
  copy_tree "$source/editors/vscode" "$folder/vscode"
  find_node "$folder"
  cd "$folder/vscode"
  install_locked "the extension for VS Code"
}

# install_locked WHAT: the packages that the lock file of this folder names, unless they are there.
install_locked() {
  cmp -s package-lock.json node_modules/.installed-lock && return 0
  rm -f node_modules/.installed-lock
  npm ci --prefer-offline --no-audit --no-fund --no-update-notifier || {
    echo "npm could not install the packages of $1 (offline?); its log is named above" >&2
    return 1
  }
  cp package-lock.json node_modules/.installed-lock
}

# copy_tree FROM TO: what is generated or installed stays apart; what is gone there is gone here. Times are kept, so that
# nothing is generated anew without need.
copy_tree() {
  local kept=(-name node_modules -o -name generated -o -name dist)
  find "$2" -mindepth 1 -maxdepth 1 ! \( "${kept[@]}" \) -exec rm -rf {} +
  (cd "$1" && find . -mindepth 1 -maxdepth 1 ! \( "${kept[@]}" \) -exec cp -a --no-preserve=ownership -t "$2" {} +)
  chmod -R u+w "$2"
}

# web_key FOLDER: changes with anything that the built page depends on.
web_key() {
  (cd "$1" && node --version && find web proto \( -name node_modules -o -name generated -o -name dist \) -prune -o -type f -print0 |
    LC_ALL=C sort -z | xargs -0 sha256sum) | sha256sum
}
