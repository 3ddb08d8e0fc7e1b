"""Which steps have passed on this very tree, and the commit on which all of them have."""
import hashlib
import json
import subprocess

from shell import ROOT, output_of

PROVEN = ROOT / "tests/proven"


def head() -> str:
    """The commit that is checked out; "" without git."""
    try:
        return output_of("git", "rev-parse", "HEAD")
    except (OSError, subprocess.CalledProcessError):
        return ""


def tree_key() -> str:
    """Of the committed tree, what is changed, and what is new; "" without git."""
    try:
        tree = output_of("git", "rev-parse", "HEAD^{tree}")
        digest = hashlib.sha256(tree.encode())
        digest.update(output_of("git", "diff", "HEAD", "--binary").encode(errors="replace"))
        for name in output_of("git", "ls-files", "--others", "--exclude-standard").splitlines():
            digest.update(name.encode() + (ROOT / name).read_bytes())
    except (OSError, subprocess.CalledProcessError):
        return ""
    return digest.hexdigest()[:16]


class Memory:
    def __init__(self, tier: str, keeps: bool, forget: bool):
        self.key = tree_key() if keeps else ""
        self.file = ROOT / "build/proof" / f"{tier}_{self.key}.json"
        self.steps = {}
        if self.key and self.file.is_file() and not forget:
            self.steps = json.loads(self.file.read_text(encoding="utf-8"))

    def passed(self, name: str) -> dict | None:
        """Seconds and passed tests of a step that has passed on this tree before."""
        return self.steps.get(name)

    def note(self, name: str, seconds: float, passed: int) -> None:
        if not self.key:
            return
        self.steps[name] = {"seconds": seconds, "passed": passed}
        self.file.parent.mkdir(parents=True, exist_ok=True)
        self.file.write_text(json.dumps(self.steps, indent=1), encoding="utf-8")

    def write_proven(self, rows: list) -> None:
        """Names HEAD as proven, unless the tree has changed since, or is not clean."""
        if not self.key or output_of("git", "status", "--porcelain") or tree_key() != self.key:
            print("tests/proven is not written: the tree is not that of a commit")
            return
        lines = ["# toolchain/prove.sh wrote this when all had passed on the commit below.",
                 output_of("git", "rev-parse", "HEAD"),
                 *(f"# {seconds:6.0f} s  {name}" for name, seconds, _ in rows)]
        PROVEN.write_text("\n".join(lines) + "\n", encoding="utf-8")
        print(f"{PROVEN.relative_to(ROOT)} names {lines[1]}: commit it")


def proven_commit() -> str:
    """The commit that prove.sh passed on last; "" when there is none in this clone."""
    if not PROVEN.is_file():
        return ""
    names = [line for line in PROVEN.read_text(encoding="utf-8").splitlines()
             if line and not line.startswith("#")]
    known = subprocess.run(["git", "cat-file", "-e", f"{names[0]}^{{commit}}"], cwd=ROOT,
                           capture_output=True, check=False)
    return names[0] if known.returncode == 0 else ""
