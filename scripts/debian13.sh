#!/usr/bin/env bash
# Builds and tests the last commit on Debian 13: unpacks a minimal Debian 13 in build-debian13/, clones the
# commit into it, and runs scripts/demo.sh and scripts/test.sh there, with warnings as errors. Then makes the Debian
# package, and installs and uses it there. Needs root, the package debootstrap, 10 GB and about an hour. Run again, it
# continues with what has not passed yet.
#
#   scripts/debian13.sh                  demo, tests and package
#   scripts/debian13.sh COMMAND [...]    runs a command in the clone instead, for example bash
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

folder=$PWD/build-debian13
root=$folder/root
if [[ $(id --user) -ne 0 ]]; then
  echo "debian13.sh: chroot needs root. Run it as root." >&2
  exit 2
fi
if ! command -v debootstrap >/dev/null; then
  echo "debian13.sh: debootstrap is missing. To install it: apt-get install debootstrap" >&2
  exit 2
fi
if [[ ! -e $folder/complete ]]; then
  rm -rf "$folder"
  mkdir -p "$folder"
  debootstrap --variant=minbase --include=ca-certificates trixie "$root" http://deb.debian.org/debian
  cat >"$root/etc/apt/sources.list" <<'END'
deb http://deb.debian.org/debian trixie main
deb http://deb.debian.org/debian trixie-updates main
deb http://deb.debian.org/debian-security trixie-security main
END
  touch "$folder/complete"
fi

commit=$(git rev-parse HEAD)
clone=$root/root/crossfield
if [[ ! -e $clone || $(git -C "$clone" rev-parse HEAD) != "$commit" ]]; then
  rm -rf "$clone"
  git clone --quiet --no-hardlinks . "$clone"
fi

# Runs a command in the clone. The mounts and all processes end with it.
in_debian13() {
  unshare --mount --pid --fork --kill-child bash -euc '
    root=$1
    shift
    mount -t proc proc "$root/proc"
    mount --rbind /sys "$root/sys"
    mount --rbind /dev "$root/dev"
    exec chroot "$root" /usr/bin/env --ignore-environment --chdir=/root/crossfield HOME=/root \
      PATH=/usr/sbin:/usr/bin:/sbin:/bin LANG=C.UTF-8 TERM="${TERM:-dumb}" CROSSFIELD_WARNINGS_AS_ERRORS=ON "$@"
  ' - "$root" "$@"
}

if [[ $# -gt 0 ]]; then
  in_debian13 "$@"
  exit
fi
for script in demo test deb; do
  passed=$folder/passed-$script
  if [[ -e $passed && $(<"$passed") == "$commit" ]]; then
    echo "scripts/$script.sh has passed on Debian 13 before: $commit"
    continue
  fi
  if [[ $script == deb ]]; then
    in_debian13 scripts/deb.sh --test --install
    in_debian13 bash tests/package/use_package.sh /tmp/use_package build/tests/install/example
    in_debian13 apt-get --quiet remove --yes crossfield # a further run must not find it
  else
    in_debian13 "scripts/$script.sh"
  fi
  echo "$commit" >"$passed"
done
