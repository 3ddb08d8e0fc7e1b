#!/usr/bin/env python3
"""Tests every file of every command: a file that cannot be read or written is reported, and no
data is lost.

    files_test.py KERFLINE
"""

import contextlib
import itertools
import os
import pathlib
import random
import signal
import stat
import subprocess
import sys
import tempfile
import time
import unittest

from files_bench import (CALLS, COMMANDS, DEVICES, ENVIRONMENT, KERFLINE, NO_FILES, PROGRAM, SEED, SETTINGS, SURFACES,
                         Bench, Server, commands_in, file_options_in, limit_files, obey_modes, some_calls)


class Files(unittest.TestCase):
    @contextlib.contextmanager
    def bench(self, name, command, **what):
        with tempfile.TemporaryDirectory() as folder, self.subTest(name, **what):
            yield Bench(pathlib.Path(folder), name, command)

    def refused(self, done, *names, status=2):
        code, out, err = done
        self.assertEqual(code, status, (out, err))
        self.assertEqual(out, "")
        for name in names:
            self.assertIn(str(name), err)
        self.assertNotIn("broken contract", err)

    def test_every_command_and_every_file_is_in_the_table(self):
        for name, text in commands_in():
            if name in NO_FILES:
                continue
            self.assertIn(name, COMMANDS)
            known = {option for called, command in CALLS if called == name
                     for option in (*command.inputs, *command.outputs, *command.kept, *command.updates)}
            known |= {option for called, option in DEVICES if called == name}
            self.assertEqual(file_options_in(text), known, name)

    def test_every_call_of_the_table_is_sound(self):
        for name, command in CALLS:
            with self.bench(name, command) as bench:
                code, out, err = bench.run()
                self.assertEqual(code, 0, (out, err))
                for option in command.outputs:
                    self.assertNotIn("previous\n", bench.files[option].read_bytes().decode("latin-1"))
                self.assertEqual([path.name for path in bench.folder.glob(".*")], [])

    def unreadable(self, bench, option=""):
        """Returns names that nobody can read, not even root, and the expected message for each."""
        folder = bench.folder / "folder"
        folder.mkdir()
        dangling, loop = bench.folder / "dangling", bench.folder / "loop"
        dangling.symlink_to(bench.folder / "nothing")
        loop.symlink_to(loop)
        binary = bench.folder / "binary"
        choose = random.Random(SEED)
        binary.write_bytes(bytes(choose.randrange(256) for _ in range(5000)))
        wide = bench.folder / "wide"
        wide.write_bytes(SETTINGS.encode("utf-16") * 10)
        yield folder, "Is a directory"
        yield bench.folder / "missing", "No such file"
        yield dangling, "No such file"
        yield loop, "Too many levels"
        yield "/proc/self/mem", "Input/output error"
        yield binary, "is no PNG" if option == "IMAGE" else "binary"
        yield wide, "UTF-16" if option in SURFACES else "is no PNG" if option == "IMAGE" else "binary"
        locked = bench.folder / "locked"
        locked.write_text("")
        locked.chmod(0)
        yield locked, "Permission denied"

    def test_what_cannot_be_read_is_told_in_one_message_with_its_name(self):
        for name, command in CALLS:
            for option in (*command.inputs, *command.updates):
                with self.bench(name, command, option=option) as bench:
                    bad_files = list(self.unreadable(bench, f"{name} {option}" if option == "FILE" else option))
                    before = bench.contents()
                    for bad, reason in bad_files:
                        done = bench.run({**bench.files, option: bad}, preexec_fn=obey_modes)
                        self.refused(done, bad, reason)
                        self.assertEqual(done[2].count("\n"), 1, done[2])
                    self.assertEqual(bench.contents(), before)

    def test_data_bases_and_stores_that_cannot_be_read_are_told(self):
        for name, command in CALLS:
            for option in set(command.kept) - {"--pty", "--slcan"}:
                with self.bench(name, command, option=option) as bench:
                    creates = command.kept[option] is None
                    bad_files = [(bad, reason) for bad, reason in self.unreadable(bench)
                                 if not (creates and reason == "No such file")]
                    before = bench.contents()
                    for bad, _ in bad_files:
                        done = bench.run({**bench.files, option: bad}, preexec_fn=obey_modes)
                        self.refused(done, bad)
                        self.assertEqual(done[2].count("\n"), 1, done[2])
                    self.assertEqual(bench.contents(), before)

    def test_what_is_empty_is_told(self):
        for name, command in CALLS:
            with self.bench(name, command) as bench:
                before = bench.contents()
                if command.updates:
                    self.refused(bench.run({**bench.files, "FILE": "-"}), "--update", "standard input")
                if command.takes_stdin:
                    positional = next(iter(command.inputs))
                    self.refused(bench.run({**bench.files, positional: "-"}), "standard input: is empty")
                for option in command.empty_is_refused:
                    empty = bench.folder / "empty"
                    empty.write_text("")
                    self.refused(bench.run({**bench.files, option: empty}), empty)
                    empty.unlink()
                self.assertEqual(bench.contents(), before)

    def test_no_file_is_both_input_and_output(self):
        """This holds under another path and through links, too, and for files that do not exist yet."""
        for name, command in some_calls(self):
            files = (*command.inputs, *command.outputs, *command.kept)
            for one, two in itertools.combinations(files, 2):
                if one in command.inputs and two in command.inputs:
                    continue
                with self.bench(name, command, one=one, two=two) as bench:
                    same = bench.files[one]
                    link, hard = bench.folder / "link", bench.folder / "hard"
                    link.symlink_to(same.name)
                    aliases = [same, link, f"./{same.name}", f"../{bench.folder.name}/{same.name}"]
                    if same.exists():
                        os.link(same, hard)
                        aliases.append(hard)
                    before = bench.contents()
                    for alias in aliases:
                        done = bench.run({**bench.files, two: alias})
                        self.refused(done, one, two, "is the same file as")
                        self.assertEqual(bench.contents(), before)

    def test_standard_output_is_no_input_and_no_other_output(self):
        for name, command in some_calls(self):
            for option in (*command.inputs, *command.outputs):
                with self.bench(name, command, option=option) as bench:
                    before = bench.contents()
                    with bench.files[option].open("a") as stream:
                        done = bench.run(stdout=stream)
                    self.refused(done, option, "standard output")
                    self.assertEqual(bench.contents(), before)

    def test_a_full_disk_costs_the_new_file_only(self):
        for name, command in some_calls(self):
            for option in (*command.outputs, *command.updates):
                with self.bench(name, command, option=option) as bench:
                    wanted = bench.needed(option)
                    before = bench.contents()
                    for size in (0, 5, 40):
                        code, _, err = bench.run(wanted, preexec_fn=limit_files(size))
                        self.assertEqual(code, 2, err)
                        self.assertIn(str(bench.files[option]), err)
                        self.assertEqual(bench.contents(), before)

    def test_a_disk_is_full_in_earnest(self):
        """The same test on a file system of 64 KiB, mounted in a separate name space if necessary."""
        done = subprocess.run([sys.executable, "-B", __file__, "--on-full-disk", KERFLINE[0]],
                              capture_output=True, text=True, check=False)
        if done.returncode != 0:
            done = subprocess.run(["unshare", "--user", "--map-root-user", "--mount", sys.executable, "-B", __file__,
                                   "--on-full-disk", KERFLINE[0]], capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 0, f"needs the right to mount, or name spaces of users:\n{done.stderr}")

    def test_places_that_take_no_file_are_told(self):
        for name, command in some_calls(self):
            for option in command.outputs:
                with self.bench(name, command, option=option) as bench:
                    wanted = bench.needed()
                    folder = bench.folder / "folder"
                    folder.mkdir()
                    loop = bench.folder / "loop"
                    loop.symlink_to(loop)
                    for bad, reason in ((folder, "Is a directory"), (folder / "no" / "such", "No such file"),
                                        (loop, "Too many levels"), ("/dev/full", "No space left"),
                                        ("", "the name of a file is missing"), ("-", "standard input")):
                        code, _, err = bench.run({**wanted, option: bad})
                        self.assertEqual(code, 2, err)
                        self.assertIn(reason, err)
                        self.assertIn(str(bad), err)

    def test_links_and_modes_stay(self):
        for name, command in some_calls(self):
            for option in command.outputs:
                with self.bench(name, command, option=option) as bench:
                    (bench.folder / "far").mkdir()
                    far, link = bench.folder / "far" / "file", bench.folder / "link"
                    link.symlink_to("far/file")
                    wanted = bench.needed()
                    for mode in (None, 0o640):
                        if mode:
                            far.write_text("old")
                            far.chmod(mode)
                        code, _, err = bench.run({**wanted, option: link})
                        self.assertEqual(code, 0, err)
                        self.assertTrue(link.is_symlink())
                        self.assertNotEqual(far.read_bytes()[:3], b"old")
                        if mode:
                            self.assertEqual(far.stat().st_mode & 0o777, mode)

    def test_devices_and_pipes_are_written_directly(self):
        for name, command in some_calls(self):
            for option in command.outputs:
                with self.bench(name, command, option=option) as bench:
                    wanted = bench.needed()
                    code, out, err = bench.run({**wanted, option: "/dev/stdout"})
                    self.assertEqual(code, 0, err)
                    self.assertGreater(len(out), 10)
                    self.assertEqual(bench.run({**wanted, option: "/dev/null"})[0], 0)
                    self.assertEqual(self.read_by_pipe(bench, wanted, option)[0], 0)

    @staticmethod
    def read_by_pipe(bench, wanted, option):
        """Returns the status, and the bytes that come out of a named pipe."""
        pipe = bench.folder / "pipe"
        os.mkfifo(pipe)
        # The output goes into a file, as a picture is larger than the capacity of two pipes.
        with tempfile.TemporaryFile() as kept:
            with subprocess.Popen(["cat", pipe], stdout=kept):
                done = bench.run({**wanted, option: pipe})
            kept.seek(0)
            data = kept.read()
        assert len(data) > 10, data
        assert stat.S_ISFIFO(pipe.stat().st_mode)
        return done

    def test_a_pipe_that_nothing_reads_is_told(self):
        """All commands run at the same time, as each waits some seconds for a reader."""
        with contextlib.ExitStack() as stack:
            started = []
            for name, command in some_calls(self):
                for option in command.outputs[:1]:
                    bench = Bench(pathlib.Path(stack.enter_context(tempfile.TemporaryDirectory())), name, command)
                    pipe = bench.folder / "pipe"
                    os.mkfifo(pipe)
                    started.append((name, option, pipe, bench.start({**bench.needed(option), option: pipe})))
            for name, option, pipe, process in started:
                with self.subTest(name, option=option):
                    _, err = process.communicate(timeout=60)
                    self.assertEqual(process.returncode, 2, err)
                    self.assertIn(f"nothing reads the pipe {pipe}", err.decode())

    def test_a_signal_leaves_nothing_behind(self):
        """kill_test.py ends processes at each of their calls; here a signal lets them remove their
        temporary files.
        """
        choose = random.Random(SEED)
        for name, command in some_calls(self):
            for option in (*command.outputs, *command.updates):
                with self.bench(name, command, option=option, seed=SEED) as bench:
                    wanted = bench.needed(option)
                    old = bench.files[option].read_bytes()
                    begun = time.monotonic()
                    self.assertEqual(bench.run(wanted)[0], 0)
                    lasted = time.monotonic() - begun
                    for how in (signal.SIGTERM, signal.SIGINT):
                        bench.files[option].write_bytes(old)
                        left = set(bench.folder.glob(".*"))
                        process = bench.start(wanted)
                        time.sleep(choose.uniform(0.0, lasted))
                        process.send_signal(how)
                        process.communicate(timeout=60)
                        self.assertEqual(set(bench.folder.glob(".*")), left)

    @staticmethod
    @contextlib.contextmanager
    def dead_output(kind):
        """Returns the arguments of a process whose standard output fails, and the reason in its message."""
        if kind == "full":
            with open("/dev/full", "w", encoding="ascii") as full:
                yield {"stdout": full}, "No space left on device"
        elif kind == "closed":
            yield {"stdout": None, "preexec_fn": lambda: os.close(1)}, "Bad file descriptor"
        else:
            reader, writer = os.pipe()
            os.close(reader)
            try:
                yield {"stdout": writer}, "Broken pipe"
            finally:
                os.close(writer)

    def test_standard_output_that_takes_nothing_is_an_error(self):
        for name, command in some_calls(self):
            with self.bench(name, command) as bench:
                code, out, err = bench.run()
                self.assertEqual(code, 0, err)
            for kind in ("full", "closed", "pipe") if out else ():
                with self.bench(name, command, kind=kind) as bench, self.dead_output(kind) as (how, reason):
                    code, _, err = bench.run(**how)
                    self.assertEqual(code, 2, err)
                    self.assertIn(f"standard output: {reason}", err)

    def test_completion_and_manual_tell_a_full_output(self):
        for words in (["completion", "bash"], ["manual"], ["--help"], ["sim", "--help"], ["--version"]):
            with open("/dev/full", "w", encoding="ascii") as full:
                done = subprocess.run([KERFLINE[0], *words], stdout=full, stderr=subprocess.PIPE, text=True,
                                      check=False, env=ENVIRONMENT)
            self.assertEqual(done.returncode, 2, words)
            self.assertIn("standard output: No space left", done.stderr)


def try_full_disk():
    """Writes a trace that does not fit on the disk; returns status, message, and the remaining files."""
    with tempfile.TemporaryDirectory() as place:
        subprocess.run(["mount", "-t", "tmpfs", "-o", "size=64k", "none", place], check=True)
        try:
            folder = pathlib.Path(place)
            job, trace = folder / "job.nc", folder / "trace"
            job.write_text(PROGRAM)
            trace.write_text("old")
            (folder / "filling").write_bytes(b"x" * (40 << 10))
            words = [KERFLINE[0], "sim", job, "--trace", trace]
            done = subprocess.run(words, capture_output=True, text=True, check=False, env=ENVIRONMENT)
            assert done.returncode == 2, done.stderr
            assert "No space left" in done.stderr, done.stderr
            assert trace.read_text() == "old"
            assert len(list(folder.iterdir())) == 3, list(folder.iterdir())
        finally:
            subprocess.run(["umount", place], check=True)


if __name__ == "__main__" and sys.argv[1] == "--on-full-disk":
    KERFLINE[0] = sys.argv[2]
    try_full_disk()
elif __name__ == "__main__":
    KERFLINE[0] = sys.argv[1]
    print(f"seed {SEED}", file=sys.stderr)
    Server.start()
    try:
        unittest.main(argv=[sys.argv[0], *sys.argv[2:]])
    finally:
        Server.stop()
