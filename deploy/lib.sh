# shellcheck shell=bash
# Shared functions of the scripts in this folder. Source it; it sets repo_root.

repo_root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

say() { printf '==> %s\n' "$*"; }

fail() {
  printf '%s: %s\n' "${0##*/}" "$*" >&2
  exit 1
}

# configure_and_build PRESET [-DOPTION=VALUE]... [TARGET...]: builds the tree in build/PRESET; without
# targets, all of it.
configure_and_build() {
  local preset=$1 options=()
  shift
  while [[ ${1-} == -D* ]]; do
    options+=("$1")
    shift
  done
  say "configuring build/$preset"
  (cd "$repo_root" && cmake --preset "$preset" "${options[@]}")
  say "building build/$preset"
  cmake --build "$repo_root/build/$preset" ${1:+--target "$@"}
}
