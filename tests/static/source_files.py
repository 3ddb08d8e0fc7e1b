"""The files that the checks look at."""
import pathlib
import subprocess

ROOT = pathlib.Path(__file__).resolve().parents[2]
SOURCE_SUFFIXES = (".hpp", ".cpp", ".c", ".h", ".py", ".cmake", ".sh", "CMakeLists.txt")
NOT_OURS = {".git", "build", "out"}


def project_files(root: pathlib.Path) -> list:
    """Every file that is committed or would be; without git, all outside the build folders."""
    git = subprocess.run(
        ["git", "-c", "safe.directory=*", "-C", str(root),
         "ls-files", "-z", "--cached", "--others", "--exclude-standard"],
        capture_output=True, text=True, check=False)
    if git.returncode == 0:
        paths = {root / name for name in git.stdout.split("\0") if name}
    else:
        paths = {path for path in root.rglob("*")
                 if not NOT_OURS.intersection(path.relative_to(root).parts)}
    return sorted(path for path in paths if path.is_file())


def source_files(root: pathlib.Path, *endings: str) -> list:
    """The project's sources with one of the endings; all sources when none is given."""
    return [path for path in project_files(root) if path.name.endswith(endings or SOURCE_SUFFIXES)]
