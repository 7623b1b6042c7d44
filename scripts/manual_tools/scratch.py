"""A scratch copy of the checkout in which a page's commands are run."""

import os
import pathlib
import shutil
import subprocess

# Adds the options of the mark 'run shortened' to the verbs that play games.
WRAPPER = r"""#!/usr/bin/env bash
case "$1 $2" in
  "play "* | "run "* | "compare "* | "live "* | "judge "* | "check "* | "submit "* | "bench "* | "team play" | \
      "team check")
    exec {program} "$@" $AUTOREF_SHORTENED ;;
esac
exec {program} "$@"
"""


def all_files(root):
    """Without git: the files outside the folders that programs write."""
    written = {root / ".git", root / "build", root / "results" / "runs"}
    for folder, folders, files in os.walk(root):
        folders[:] = [name for name in folders if pathlib.Path(folder, name) not in written]
        yield from (os.path.relpath(os.path.join(folder, name), root) for name in files)


def tracked_files(root):
    """The files that git knows, or would add."""
    command = ["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard"]
    listed = subprocess.run(command, cwd=root, capture_output=True, check=False)
    if listed.returncode != 0 or not (root / ".git").exists():
        return all_files(root)
    return [name for name in listed.stdout.decode().split("\0") if name]


def copy_checkout(root, folder):
    for name in tracked_files(root):
        source, target = pathlib.Path(root, name), pathlib.Path(folder, name)
        if source.is_file():
            target.parent.mkdir(parents=True, exist_ok=True)
            shutil.copy2(source, target)


def add_build(program, folder):
    """build/release/ with the program's folder, and the program itself in a wrapper."""
    real = pathlib.Path(program).resolve()
    build = pathlib.Path(folder, "build", "release")
    (build / "bin").mkdir(parents=True)
    for file in real.parent.iterdir():
        if file.name != real.name:
            (build / "bin" / file.name).symlink_to(file)
    wrapper = build / "bin" / "autoref"
    wrapper.write_text(WRAPPER.format(program=real), encoding="utf-8")
    wrapper.chmod(0o755)
    package = real.parent.parent / "python"
    if package.is_dir():
        (build / "python").symlink_to(package)


def environment_in(folder):
    """Bare `autoref` is found, and the Python package uses the same program."""
    program = str(pathlib.Path(folder, "build", "release", "bin", "autoref"))
    path = f"{os.path.dirname(program)}:/usr/bin:{os.environ['PATH']}:/usr/sbin"
    return os.environ | {"PATH": path, "AUTOREF": program, "AUTOREF_SHORTENED": ""}


# Commands get their own network, in which they may set up the loopback; `sudo` is not needed there. The addresses are
# the examples used on the pages.
NETWORK = """
ip link set lo up multicast on
for address in 192.168.1.5 192.168.1.20; do ip address add $address/24 dev lo; done
sudo() { "$@"; }
export -f sudo
"""


def in_own_network(*command):
    """Root keeps its rights, among them to start programs under other users; others need a user namespace."""
    return ["unshare", "-n" if os.geteuid() == 0 else "-rn", *command]


def has_own_network():
    return (
        subprocess.run(in_own_network("ip", "link", "set", "lo", "up"), capture_output=True, check=False).returncode
        == 0
    )
