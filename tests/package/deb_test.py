"""Packs the build as a Debian package, installs it into a clean Debian and works with it there.

usage: deb_test.py CPACK BUILD_FOLDER

Needs root, for chroot, and the Debian archive that the machine itself installs from.
"""
import os
import pathlib
import re
import shutil
import socket
import subprocess
import sys
import tempfile
import threading
import time
import unittest
import urllib.request

CPACK, BUILD = sys.argv[1], pathlib.Path(sys.argv[2])
EXAMPLES = "/usr/share/doc/kerfline/examples"
BANNER = b"Grbl 1.1h ['$' for help]\r\n"
LONGEST_S = 400  # Of a command: the archive may be slow, but a test that hangs says where.


def run(*command, **options):
    """Returns standard output. Raises an error with the output as message if the command failed."""
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True, check=False,
                          stdin=subprocess.DEVNULL, timeout=LONGEST_S, **options)
    if done.returncode != 0:
        raise AssertionError(f"{command}: status {done.returncode}\n{done.stdout}\n{done.stderr}")
    return done.stdout


def sources_of_the_machine() -> list:
    apt = pathlib.Path("/etc/apt")
    files = [apt / "sources.list", *sorted(apt.glob("sources.list.d/*.list")),
             *sorted(apt.glob("sources.list.d/*.sources"))]
    return [file for file in files if file.is_file()]


def make_clean_root(root: pathlib.Path, scratch: pathlib.Path):
    """Makes a Debian of the machine's own release that contains only apt, configured as on the
    machine."""
    options = scratch / "acquire.conf"
    options.write_text(run("apt-config", "dump", "Acquire"), encoding="utf-8")
    release = re.search(r"^VERSION_CODENAME=(\w+)", pathlib.Path("/etc/os-release").read_text(), re.M)[1]
    run("mmdebstrap", "--variant=apt", f"--aptopt={options}", "--skip=cleanup/apt/lists",
        release, root, *sources_of_the_machine())
    shutil.copy("/etc/resolv.conf", root / "etc/resolv.conf")


class Package(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        scratch = pathlib.Path(folder.name)
        run(CPACK, "--config", BUILD / "CPackConfig.cmake", "-B", scratch / "packed")
        [cls.deb] = (scratch / "packed").glob("*.deb")
        cls.root = scratch / "root"
        make_clean_root(cls.root, scratch)
        shutil.copy(cls.deb, cls.root)
        cls.inside("apt-get", "install", "-y", "--no-install-recommends", f"/{cls.deb.name}",
                   env={**os.environ, "DEBIAN_FRONTEND": "noninteractive"})

    @classmethod
    def inside(cls, *command, **options):
        return run("chroot", cls.root, *command, **options)

    def field(self, name):
        return run("dpkg-deb", "--field", self.deb, name).strip()

    def test_names_version_and_dependencies(self):
        version = run(BUILD / "host-sim/kerfline", "--version").strip()
        self.assertEqual(self.field("Version"), version.replace("-", "+"))
        self.assertEqual(self.field("Package"), "kerfline")
        needed = self.field("Depends")
        for name in ("libc6", "libcairo2", "librsvg2-2", "libsqlite3-0", "fonts-dejavu-core"):
            self.assertIn(name, needed)
        self.assertNotIn("-dev", needed)

    def test_has_manual_completions_and_licence(self):
        listed = set(self.inside("dpkg", "--listfiles", "kerfline").split("\n"))
        for name in ("man/man1/kerfline.1", "bash-completion/completions/kerfline",
                     "zsh/vendor-completions/_kerfline", "fish/vendor_completions.d/kerfline.fish",
                     "doc/kerfline/copyright"):
            self.assertIn(f"/usr/share/{name}", listed)

    def test_version(self):
        self.assertEqual(self.inside("kerfline", "--version"),
                         run(BUILD / "host-sim/kerfline", "--version"))

    def test_cuts_an_example_drawing(self):
        self.inside("kerfline", "cut", f"{EXAMPLES}/plate.svg", "--material", "CSP 1N",
                    "--thickness", "2", "-o", "/plate.nc", "--svg", "/plate.svg")
        self.assertIn("G1", (self.root / "plate.nc").read_text())
        self.inside("kerfline", "sim", "/plate.nc", "--settings", f"{EXAMPLES}/laser.settings",
                    "--png", "/plate.png")
        self.assertEqual((self.root / "plate.png").read_bytes()[:4], b"\x89PNG")

    def test_serves(self):
        with subprocess.Popen(["chroot", self.root, "kerfline", "serve", "--tcp", "0", "--ws", "0"],
                              stdout=subprocess.PIPE, text=True) as served:
            end_of_all = threading.Timer(LONGEST_S, served.kill)
            end_of_all.start()
            try:
                ways = dict(served.stdout.readline().split() for _ in range(3))
                with socket.create_connection(ways["tcp"].rsplit(":", 1), timeout=10) as link:
                    said, end = b"", time.monotonic() + 10
                    while BANNER not in said and time.monotonic() < end:
                        said += link.recv(4096)
                    self.assertIn(BANNER, said)
                    link.sendall(b"$I\n")
                    while b"ok\r\n" not in said and time.monotonic() < end:
                        said += link.recv(4096)
                version = run(BUILD / "host-sim/kerfline", "--version").strip()
                self.assertIn(f"[KERFLINE:{version}]", said.decode())
                direct = urllib.request.build_opener(urllib.request.ProxyHandler({}))
                with direct.open(ways["page"], timeout=10) as page:
                    self.assertIn(b"<title>Kerfline</title>", page.read())
            finally:
                served.terminate()
                served.wait()
                end_of_all.cancel()


if __name__ == "__main__":
    if os.geteuid() != 0:
        sys.exit("deb_test: only root may chroot; run it as root")
    if shutil.which("mmdebstrap") is None or shutil.which("dpkg-shlibdeps") is None:
        sys.exit("deb_test: mmdebstrap or dpkg-dev is missing; install [prove] of toolchain/packages.txt")
    unittest.main(argv=sys.argv[:1])
