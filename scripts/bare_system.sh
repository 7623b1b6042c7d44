# shellcheck shell=bash
# Sets up a bare Debian 12 in a folder and runs commands in it. Other scripts source this file.
# Needs root, debootstrap and Debian's mirror ($DEBIAN_MIRROR).

fail() {
  echo "${0##*/}: $1" >&2
  exit 1
}
step() { echo "$SECONDS s: $1"; }

# Unpacks a bare system with git into the folder ROOT. The downloaded system stays in WORKPLACE/bare.tar for the next run.
make_bare_system() { # WORKPLACE ROOT
  ((EUID == 0)) || fail "needs root"
  command -v debootstrap >/dev/null || fail "needs debootstrap: apt-get install debootstrap"
  mkdir -p "$1"
  if [[ ! -e $1/bare.tar ]]; then
    step "download a bare system"
    rm -rf "$1/bare"
    debootstrap --variant=minbase --include=git,ca-certificates bookworm "$1/bare" \
      "${DEBIAN_MIRROR:-http://deb.debian.org/debian}" >"$1/debootstrap.log" || { tail "$1/debootstrap.log" >&2; fail "debootstrap failed"; }
    # The mirrors used by this machine.
    [[ -z ${DEBIAN_MIRROR:-} ]] || echo "deb $DEBIAN_MIRROR bookworm main" >"$1/bare/etc/apt/sources.list"
    tar -C "$1/bare" -cf "$1/bare.part" .
    mv "$1/bare.part" "$1/bare.tar"
    rm -rf "$1/bare"
  fi
  rm -rf "$2"
  mkdir -p "$2"
  tar -C "$2" -xf "$1/bare.tar"
}

# Runs a shell command in the system in the folder ROOT, as root, with its own process ids and mounts. Everything that
# it has started ends with it. (A plain chroot would provide no user namespaces.)
in_bare_system() { # ROOT COMMAND
  unshare --mount --pid --fork --kill-child sh -ec '
    mount --bind "$0" "$0"
    cd "$0"
    mount -t proc proc proc
    mount --rbind /sys sys
    mount --rbind /dev dev
    mount -t tmpfs tmpfs dev/shm
    mkdir -p old
    pivot_root . old
    umount -l /old
    exec env -i PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LC_ALL=C.UTF-8 \
      DEBIAN_FRONTEND=noninteractive sh -ec "$1"' "$1" "$2" </dev/null
}
