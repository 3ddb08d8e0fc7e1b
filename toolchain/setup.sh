#!/usr/bin/env bash
# Installs the missing Debian packages of packages.txt, and nothing else. `setup.sh run` installs
# the packages for building and running, `setup.sh test` also those for the tests, `setup.sh prove`
# all of them. It asks no questions, and needs root only if packages are missing.
set -euo pipefail

here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
part=${1:-run}
case $part in
  run) parts=' run ' ;;
  test) parts=' run test ' ;;
  prove) parts=' run test prove ' ;;
  *) echo "usage: setup.sh [run|test|prove]" >&2; exit 2 ;;
esac

wanted=()
section=
while read -r line; do
  read -r package unless command <<<"${line%%#*}"
  if [[ $package == '['*']' ]]; then
    section=${package:1:-1}
  elif [[ -n $package && $parts == *" $section "* ]]; then
    [[ $unless == unless ]] && command -v "$command" >/dev/null && continue
    wanted+=("$package")
  fi
done <"$here/packages.txt"

# dpkg-query fails for packages that it does not know; these are missing, too.
installed=$(dpkg-query -W -f='${Package} ${db:Status-Status}\n' "${wanted[@]}" 2>/dev/null || true)
missing=()
for package in "${wanted[@]}"; do
  grep -qxF "$package installed" <<<"$installed" || missing+=("$package")
done
if ((${#missing[@]} == 0)); then
  echo "setup: all ${#wanted[@]} packages for '$part' are here"
  exit 0
fi

if ((EUID == 0)); then
  as_root=(env)
elif command -v sudo >/dev/null && sudo -n true 2>/dev/null; then
  as_root=(sudo -n env)
else
  echo "setup: packages are missing, and installing needs root or sudo without a password:" >&2
  echo "  apt-get install --no-install-recommends ${missing[*]}" >&2
  exit 1
fi

echo "setup: installing ${missing[*]}"
apt_get() {
  "${as_root[@]}" DEBIAN_FRONTEND=noninteractive apt-get -q -y \
    -o DPkg::Lock::Timeout=300 -o Acquire::Retries=3 -o Dpkg::Use-Pty=0 "$@" </dev/null
}
apt_get update
apt_get install --no-install-recommends "${missing[@]}"
