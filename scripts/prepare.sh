# Sourced by the scripts beside it: goes to the top folder and offers what they share.

cd "$(dirname "${BASH_SOURCE[0]}")/.."

# install_missing PACKAGE...: the Debian packages that are not there yet
install_missing() {
  if ! command -v dpkg-query > /dev/null || ! command -v apt-get > /dev/null; then
    echo "Not a Debian system: taking for granted the equivalents of $*" >&2
    return
  fi
  local missing=() package
  for package in "$@"; do
    dpkg-query -W -f '${Status}' "$package" 2> /dev/null | grep -q '^install ok installed' || missing+=("$package")
  done
  [ ${#missing[@]} -gt 0 ] || return 0
  local as_root=()
  [ "$(id -u)" -eq 0 ] || as_root=(sudo)
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get update
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends "${missing[@]}"
}

# build FOLDER [CMAKE OPTION...]: configures there and builds with all cores
build() {
  local folder=$1
  shift
  cmake -S . -B "$folder" "$@"
  cmake --build "$folder" --parallel "$(nproc)"
}

program_packages=(g++ make cmake libcgal-dev libcli11-dev libmuparser-dev nlohmann-json3-dev libtbb-dev)
