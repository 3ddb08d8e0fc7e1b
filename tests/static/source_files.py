"""Lists the files that the checks read."""
import pathlib
import subprocess

ROOT = pathlib.Path(__file__).resolve().parents[2]
SOURCE_SUFFIXES = (".hpp", ".cpp", ".c", ".h", ".py", ".cmake", ".sh", "CMakeLists.txt")
NOT_OURS = {".git", "build", "out"}


def project_files(root: pathlib.Path) -> list:
    """Returns all files of the project, committed or new; without git, all files outside of the
    build folders."""
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
    """Returns the project's sources with one of the endings; all sources if none is given."""
    return [path for path in project_files(root) if path.name.endswith(endings or SOURCE_SUFFIXES)]
